#pragma once

#include <Eigen/Dense>

#include "core/linear_algebra/block_matrix.h"

namespace sherd {

/// A x of a matrix in blocks of 3 x 3.
Eigen::VectorXd blockProduct(const BlockMatrix& matrix, const Eigen::VectorXd& x);

}  // namespace sherd
