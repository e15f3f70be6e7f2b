#include "core/linear_algebra/conjugate_gradients.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace sherd {

namespace {

using Columns = Eigen::SparseMatrix<double>;

Columns lowerTriangle(const BlockMatrix& matrix) {
    const int size = matrix.block_size;
    Columns lower(matrix.size(), matrix.size());
    lower.reserve(static_cast<long>(matrix.values.size()));
    for (int c = 0; c < matrix.blockColumns(); ++c)
        for (int j = 0; j < size; ++j) {
            lower.startVec(size * c + j);
            const double* value = matrix.column(c, j);
            for (int k = matrix.starts[c]; k < matrix.starts[c + 1]; ++k, value += size)
                for (int i = matrix.rows[k] == c ? j : 0; i < size; ++i)
                    lower.insertBack(size * matrix.rows[k] + i, size * c + j) = value[i];
        }
    lower.finalize();
    return lower;
}

}  // namespace

Result<Eigen::VectorXd> solveByConjugateGradients(const BlockMatrix& matrix, const Eigen::VectorXd& b,
                                                  double tolerance) {
    constexpr int largest_iterations = 1000;
    const Columns lower = lowerTriangle(matrix);
    Eigen::ConjugateGradient<Columns, Eigen::Lower> solver;
    solver.setTolerance(tolerance);
    solver.setMaxIterations(largest_iterations);
    solver.compute(lower);
    Eigen::VectorXd x;
    if (solver.info() == Eigen::Success) x = solver.solve(b);
    if (solver.info() != Eigen::Success)
        return Error{"The iterative solve around a load did not converge; use fewer resampling rounds."};
    return x;
}

}  // namespace sherd
