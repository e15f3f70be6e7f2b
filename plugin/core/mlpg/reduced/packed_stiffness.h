#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <vector>

#include "core/linear_algebra/block_matrix.h"
#include "core/numerics/unset_vector.h"

namespace sherd {

/// A stiffness matrix in 16 bits a number: K_ij / sqrt(K_ii K_jj) lies between -1 and 1. What is lost is
/// 1.5e-5 of the diagonal; the part of a matrix around a patch is far better conditioned than that.
struct PackedStiffness {
    std::vector<int> starts;            ///< per block column and one more, into the two below
    std::vector<int> rows;              ///< block rows, from the diagonal downwards
    UnsetVector<std::int16_t> entries;  ///< 9 a block, column by column
    std::vector<float> roots;           ///< per unknown: sqrt(K_ii / 32767)

    PackedStiffness() = default;
    explicit PackedStiffness(const BlockMatrix& stiffness);

    int blockCount() const { return static_cast<int>(starts.size()) - 1; }

    /// The lower triangle of the rows and columns of `blocks` (ascending), 3 #blocks squared.
    Eigen::MatrixXf lowerPart(const std::vector<int>& blocks) const;
    /// K u, #unknowns.
    Eigen::VectorXf times(const Eigen::VectorXf& unknowns) const;
    /// About K^-1 f: so many rounds of conjugate gradients from zero, preconditioned by symmetric successive
    /// overrelaxation with a factor of 1, as in S. Eisenstat, Efficient implementation of a class of
    /// preconditioned conjugate gradient methods (1981). They find what changes from function to function
    /// first.
    Eigen::VectorXf solveRoughly(const Eigen::VectorXf& forces, int rounds) const;
    /// Those of `blocks` (ascending) that entries join, directly or by others of them: lists, each ascending,
    /// the one with the smallest number first.
    std::vector<std::vector<int>> joined(const std::vector<int>& blocks) const;
};

}  // namespace sherd
