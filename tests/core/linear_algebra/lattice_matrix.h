#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "core/linear_algebra/sparse_matrix.h"

namespace sherd {

/// A box of vertices on a lattice, each coupled with all within two layers, as quadratic splines are; blocks
/// of 3 x 3 with random numbers and a dominant diagonal, so positive definite.
struct LatticeMatrix {
    std::vector<Eigen::Vector3i> places;
    SparseMatrix lower;  ///< blocks from the diagonal ones (complete) downwards

    LatticeMatrix(int nx, int ny, int nz) {
        for (int z = 0; z < nz; ++z)
            for (int y = 0; y < ny; ++y)
                for (int x = 0; x < nx; ++x) places.emplace_back(x, y, z);
        const int count = static_cast<int>(places.size());
        constexpr double dominant = 3 * 125;  // more than the other entries of a row, which are below 1
        std::mt19937 random(3);
        lower.size = 3 * count;
        lower.starts.push_back(0);
        for (int column = 0; column < lower.size; ++column) {
            for (int row = column / 3 * 3; row < lower.size; ++row) {
                if ((places[row / 3] - places[column / 3]).cwiseAbs().maxCoeff() > 2) continue;
                const bool diagonal_block = row / 3 == column / 3;
                lower.indices.push_back(row);
                lower.values.push_back(row == column    ? dominant
                                       : diagonal_block ? 0.3
                                                        : random() / 4294967296.0);
            }
            lower.starts.push_back(static_cast<int>(lower.indices.size()));
        }
    }
};

}  // namespace sherd
