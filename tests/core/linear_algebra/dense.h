#pragma once

#include <Eigen/Dense>
#include <random>

#include "core/linear_algebra/sparse_matrix.h"

namespace sherd {

/// The lower half, from the diagonal blocks of 3 downwards, in CSC; or the whole matrix in CSR.
enum class Layout { lower_columns, rows };
inline SparseMatrix compressed(const Eigen::MatrixXd& dense, Layout layout) {
    const bool columns = layout == Layout::lower_columns;
    SparseMatrix matrix;
    matrix.size = static_cast<int>(dense.rows());
    matrix.starts.push_back(0);
    for (int line = 0; line < matrix.size; ++line) {
        for (int k = columns ? line / 3 * 3 : 0; k < matrix.size; ++k) {
            const double value = columns ? dense(k, line) : dense(line, k);
            if (!columns && value == 0) continue;
            matrix.indices.push_back(k);
            matrix.values.push_back(value);
        }
        matrix.starts.push_back(static_cast<int>(matrix.indices.size()));
    }
    return matrix;
}

inline Eigen::MatrixXd randomMatrix(int size) {
    std::mt19937 random(5);
    Eigen::MatrixXd matrix(size, size);
    for (int i = 0; i < matrix.size(); ++i) matrix(i) = random() / 4294967296.0 - 0.5;
    return matrix;
}

inline Eigen::VectorXd randomVector(long size, unsigned seed) {
    std::mt19937 random(seed);
    Eigen::VectorXd values(size);
    for (double& value : values) value = random() / 4294967296.0 - 0.5;
    return values;
}

}  // namespace sherd
