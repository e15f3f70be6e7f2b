#pragma once

#include <sherd/result.h>

#include <memory>

#include "core/linear_algebra/sparse_matrix.h"
#include "core/linear_algebra/sparse_solver.h"

namespace sherd {

/// Supernodal Cholesky factorisation of a symmetric positive definite matrix (CHOLMOD), given in CSC; entries
/// above the diagonal are ignored. Unknowns come in blocks of `block_size` with equal patterns; the
/// fill-reducing order is sought for blocks (METIS and AMD, the better one), which is far cheaper than for
/// single unknowns. A matrix that is not safely positive definite gets a small shift of its diagonal
/// (`relativeShift`).
Result<std::unique_ptr<SparseSolver>> factorCholesky(const SparseMatrix& lower, int block_size);

/// Numbers that the Cholesky factor of a symmetric matrix would store, from its pattern alone: CSC of blocks
/// of `block_size`; entries above the diagonal are ignored, values are not used.
Result<double> factorEntriesOf(const SparseMatrix& blocks, int block_size);

}  // namespace sherd
