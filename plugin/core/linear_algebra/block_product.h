#pragma once

#include <Eigen/Dense>

#include "core/linear_algebra/sparse_matrix.h"

namespace sherd {

/// A x of a symmetric matrix in CSC, in blocks of 3 x 3 from the diagonal blocks (complete) downwards.
Eigen::VectorXd symmetricBlockProduct(const SparseMatrix& lower, const Eigen::VectorXd& x);

}  // namespace sherd
