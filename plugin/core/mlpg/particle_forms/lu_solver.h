#pragma once

#include <sherd/result.h>

#include <memory>

#include "core/linear_algebra/sparse_matrix.h"
#include "core/linear_algebra/sparse_solver.h"

namespace sherd {

/// LU factorisation of a general matrix (UMFPACK), given in CSR. Solves take up to two steps of iterative
/// refinement.
Result<std::unique_ptr<SparseSolver>> factorLu(std::shared_ptr<const SparseMatrix> rows);

/// A x of a matrix in CSR.
Eigen::VectorXd product(const SparseMatrix& rows, const Eigen::VectorXd& x);

}  // namespace sherd
