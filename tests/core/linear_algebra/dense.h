#pragma once

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "core/linear_algebra/block_matrix.h"
#include "core/linear_algebra/sparse_matrix.h"

namespace sherd {

/// In blocks of 3.
inline BlockMatrix inBlocks(const Eigen::MatrixXd& dense) {
    BlockMatrix matrix;
    const int count = static_cast<int>(dense.rows()) / 3;
    for (int column = 0; column < count; ++column) {
        std::vector<int> rows;
        for (int row = column; row < count; ++row) rows.push_back(row);
        matrix.addColumn(rows);
    }
    matrix.setZero();
    for (int column = 0; column < count; ++column)
        for (int j = 0; j < 3; ++j)
            Eigen::Map<Eigen::VectorXd>(matrix.column(column, j), matrix.height(column)) =
                dense.col(3L * column + j).tail(matrix.height(column));
    return matrix;
}

/// In CSR.
inline SparseMatrix compressedRows(const Eigen::MatrixXd& dense) {
    SparseMatrix matrix;
    matrix.size = static_cast<int>(dense.rows());
    matrix.starts.push_back(0);
    for (int row = 0; row < matrix.size; ++row) {
        for (int column = 0; column < matrix.size; ++column) {
            if (dense(row, column) == 0) continue;
            matrix.indices.push_back(column);
            matrix.values.push_back(dense(row, column));
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
