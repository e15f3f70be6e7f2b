#pragma once

#include <sherd/result.h>

#include <Eigen/Core>
#include <memory>

#include "core/linear_algebra/block_matrix.h"
#include "core/linear_algebra/sparse_solver.h"

namespace sherd {

/// Of the numbers in a factor.
enum class Precision {
    refined,  ///< single, for blocks of 3: half the time and memory; PinnedSystem refines its solutions
    full      ///< double
};

/// Cholesky factorisation of a positive definite matrix. `places`: of the block columns on a lattice where
/// they couple with near ones only, or empty; they make it quick to find an order with little fill. A matrix
/// that is not safely positive definite gets a small shift of its diagonal (`relativeShift`), and one that is
/// too badly conditioned for single precision gets double.
Result<std::unique_ptr<SparseSolver>> factorCholesky(const BlockMatrix& matrix,
                                                     const std::vector<Eigen::Vector3i>& places = {},
                                                     Precision precision = Precision::full);

/// Numbers that the Cholesky factor of such a matrix has, from its pattern alone: values are not used.
Result<double> factorEntriesOf(const BlockMatrix& pattern, const std::vector<Eigen::Vector3i>& places);

}  // namespace sherd
