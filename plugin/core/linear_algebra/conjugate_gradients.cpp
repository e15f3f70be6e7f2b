#include "core/linear_algebra/conjugate_gradients.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace sherd {

Result<Eigen::VectorXd> solveByConjugateGradients(const SparseMatrix& lower, const Eigen::VectorXd& b,
                                                  double tolerance) {
    constexpr int largest_iterations = 1000;
    using Matrix = Eigen::SparseMatrix<double>;
    const Eigen::Map<const Matrix> view(lower.size, lower.size, static_cast<long>(lower.values.size()),
                                        lower.starts.data(), lower.indices.data(), lower.values.data());
    const Matrix matrix = view.triangularView<Eigen::Lower>();
    Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver;
    solver.setTolerance(tolerance);
    solver.setMaxIterations(largest_iterations);
    solver.compute(matrix);
    Eigen::VectorXd x;
    if (solver.info() == Eigen::Success) x = solver.solve(b);
    if (solver.info() != Eigen::Success)
        return Error{"The iterative solve around a load did not converge; use fewer resampling rounds."};
    return x;
}

}  // namespace sherd
