#pragma once

#include "core/linear_algebra/sparse_solver.h"

namespace sherd {

/// A x = b by conjugate gradients, preconditioned by the diagonal: for a single right-hand side and a
/// moderate accuracy faster than a factorisation, and without its memory. Symmetric positive definite; lines
/// are columns, entries above the diagonal are ignored. Fails when |A x - b| / |b| does not get below
/// `tolerance`.
Result<Eigen::VectorXd> solveByConjugateGradients(const SparseMatrix& lower, const Eigen::VectorXd& b,
                                                  double tolerance);

}  // namespace sherd
