#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "core/linear_algebra/block_matrix.h"

namespace sherd {

/// A box of vertices on a lattice, each coupled with all within two layers, as quadratic splines are; blocks
/// of 3 x 3 with random numbers and a dominant diagonal, so positive definite.
struct LatticeMatrix {
    std::vector<Eigen::Vector3i> places;
    BlockMatrix matrix;

    LatticeMatrix(int nx, int ny, int nz) {
        for (int z = 0; z < nz; ++z)
            for (int y = 0; y < ny; ++y)
                for (int x = 0; x < nx; ++x) places.emplace_back(x, y, z);
        const int count = static_cast<int>(places.size());
        constexpr double dominant = 3 * 125;  // more than the other entries of a row, which are below 1
        std::mt19937 random(3);
        for (int column = 0; column < count; ++column) {
            std::vector<int> rows;
            for (int row = column; row < count; ++row)
                if ((places[row] - places[column]).cwiseAbs().maxCoeff() <= 2) rows.push_back(row);
            matrix.addColumn(rows);
        }
        matrix.setZero();
        for (int column = 0; column < count; ++column)
            for (int j = 0; j < 3; ++j) {
                double* value = matrix.column(column, j);
                for (int i = 0; i < matrix.height(column); ++i)
                    value[i] = i == j ? dominant : i < 3 ? 0.3 : random() / 4294967296.0;
            }
    }
};

}  // namespace sherd
