#pragma once

#include <Eigen/Dense>

namespace sherd {

/// A factored sparse matrix, ready for any number of right-hand sides.
class SparseSolver {
  public:
    virtual ~SparseSolver() = default;

    /// x = A^-1 b: two triangular solves. False when the library reports a failure; x is then not to be used.
    /// May be called from several threads; calls wait for each other.
    virtual bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const = 0;

    /// The same for all columns of B; x gets its size.
    virtual bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const {
        x.resize(b.rows(), b.cols());
        Eigen::VectorXd column;
        for (Eigen::Index j = 0; j < b.cols(); ++j) {
            if (!solve(Eigen::VectorXd(b.col(j)), column)) return false;
            x.col(j) = column;
        }
        return true;
    }

    /// Numbers stored in the triangular factors.
    virtual long long factorEntries() const = 0;
    /// What these take.
    long long factorBytes() const {
        return factorEntries() * static_cast<long long>(isSingle() ? sizeof(float) : sizeof(double));
    }

    /// Estimate of 1 / condition number from the factors' diagonals.
    virtual double reciprocalCondition() const = 0;

    /// What was added to the diagonal, relative to its mean, because the matrix alone could not be factored;
    /// mostly 0.
    virtual double relativeShift() const { return 0; }

    /// Whether solutions are in single precision, and are to be refined.
    virtual bool isSingle() const { return false; }
};

}  // namespace sherd
