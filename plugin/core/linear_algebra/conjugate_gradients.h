#pragma once

#include <sherd/result.h>

#include <Eigen/Dense>

#include "core/linear_algebra/sparse_matrix.h"

namespace sherd {

/// A x = b by conjugate gradients, preconditioned by the diagonal: for a single right-hand side and a
/// moderate accuracy faster than a factorisation, and without its memory. A is symmetric positive definite,
/// in CSC; entries above the diagonal are ignored. Fails when |A x - b| / |b| does not get below `tolerance`.
Result<Eigen::VectorXd> solveByConjugateGradients(const SparseMatrix& lower, const Eigen::VectorXd& b,
                                                  double tolerance);

}  // namespace sherd
