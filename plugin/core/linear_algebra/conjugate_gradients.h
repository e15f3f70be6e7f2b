#pragma once

#include <sherd/result.h>

#include <Eigen/Dense>

#include "core/linear_algebra/block_matrix.h"

namespace sherd {

/// A x = b by conjugate gradients, preconditioned by the diagonal: for a single right-hand side and a
/// moderate accuracy faster than a factorisation, and without its memory. A is positive definite. Fails when
/// |A x - b| / |b| does not get below `tolerance`.
Result<Eigen::VectorXd> solveByConjugateGradients(const BlockMatrix& matrix, const Eigen::VectorXd& b,
                                                  double tolerance);

}  // namespace sherd
