#pragma once

#include <sherd/result.h>

#include <Eigen/Dense>
#include <memory>
#include <vector>

namespace sherd {

/// A square sparse matrix in compressed form: line l holds entries starts[l] .. starts[l + 1] - 1, in
/// ascending order of index. Lines are columns or rows, as each user says.
struct SparseMatrix {
    int size = 0;
    std::vector<int> starts;     ///< size + 1
    std::vector<int> indices;    ///< #entries
    std::vector<double> values;  ///< #entries
};

/// A factored sparse matrix, ready for any number of right-hand sides.
class SparseSolver {
  public:
    virtual ~SparseSolver() = default;

    /// x = A^-1 b: two triangular solves. False when the library reports a failure; x is then not to be used.
    /// May be called from several threads; calls wait for each other.
    virtual bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const = 0;

    /// Numbers stored in the triangular factors.
    virtual long long factorEntries() const = 0;

    /// Estimate of 1 / condition number from the factors' diagonals.
    virtual double reciprocalCondition() const = 0;

    /// What was added to the diagonal, relative to its mean, because the matrix alone could not be factored;
    /// mostly 0.
    virtual double relativeShift() const { return 0; }
};

/// Supernodal Cholesky factorisation of a symmetric positive definite matrix (CHOLMOD). Lines are columns;
/// entries above the diagonal are ignored. Unknowns come in blocks of `block_size` with equal patterns; the
/// fill-reducing order is sought for blocks (METIS and AMD, the better one), which is far cheaper than for
/// single unknowns. A matrix that is not safely positive definite gets a small shift of its diagonal
/// (`relativeShift`).
Result<std::unique_ptr<SparseSolver>> factorCholesky(const SparseMatrix& lower, int block_size);

/// Numbers that the Cholesky factor of a symmetric matrix would store, from its pattern alone: lines are
/// columns of blocks of `block_size`, entries above the diagonal are ignored, values are not used.
Result<double> factorEntriesOf(const SparseMatrix& blocks, int block_size);

/// LU factorisation of a general matrix (UMFPACK). Lines are rows. Solves take up to two steps of iterative
/// refinement.
Result<std::unique_ptr<SparseSolver>> factorLu(std::shared_ptr<const SparseMatrix> rows);

/// A x of a matrix whose lines are rows.
Eigen::VectorXd product(const SparseMatrix& rows, const Eigen::VectorXd& x);

}  // namespace sherd
