#pragma once

#include <algorithm>
#include <memory>

#include "core/linear_algebra/cholesky_solver.h"
#include "core/mlpg/splines/spline_mass.h"
#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// A solid in motion, K u + M u'' = f, by Newmark's method with the average acceleration (beta 1/4), which
/// adds and takes no energy.
class Newmark {
  public:
    struct Motion {
        Eigen::VectorXd displacement, velocity, acceleration;
        double time_s = 0;

        explicit Motion(int unknowns)
            : displacement(Eigen::VectorXd::Zero(unknowns)),
              velocity(displacement),
              acceleration(displacement) {}
    };

    explicit Newmark(const SplineProblem& problem)
        : stiffness_(stiffnessOf(problem)), mass_(splineMass(problem.parts(), *problem.space)) {
        for (double& value : mass_.values) value *= problem.density_kg_m3;
    }

    int unknowns() const { return stiffness_.size(); }

    /// K + shift M.
    Result<std::unique_ptr<SparseSolver>> shifted(double shift) const {
        BlockMatrix sum = stiffness_;
        for (int column = 0; column < sum.blockColumns(); ++column)
            for (int k = mass_.starts[column]; k < mass_.starts[column + 1]; ++k) {
                const auto begin = sum.rows.begin() + sum.starts[column];
                const auto end = sum.rows.begin() + sum.starts[column + 1];
                const long place = std::lower_bound(begin, end, mass_.indices[k]) - begin;
                for (int i = 0; i < 3; ++i) sum.column(column, i)[3 * place + i] += shift * mass_.values[k];
            }
        return factorCholesky(sum);
    }
    /// What goes on in steps of that length.
    Result<std::unique_ptr<SparseSolver>> stepper(double step_s) const {
        return shifted(4 / (step_s * step_s));
    }

    /// One step, under the force at its end. False if there is no solution.
    bool advance(const SparseSolver& stepper, double step_s, const Eigen::VectorXd& force,
                 Motion& now) const {
        const double a = 4 / (step_s * step_s), b = 4 / step_s;
        const Eigen::VectorXd known = a * now.displacement + b * now.velocity + now.acceleration;
        Eigen::VectorXd next;
        if (!stepper.solve(force + massProduct(mass_, known), next)) return false;
        const Eigen::VectorXd acceleration = a * next - known;
        now.velocity += step_s / 2 * (now.acceleration + acceleration);
        now.acceleration = acceleration;
        now.displacement = next;
        now.time_s += step_s;
        return true;
    }

  private:
    BlockMatrix stiffness_;
    SparseMatrix mass_;  ///< its pattern is among that of the stiffness
};

}  // namespace sherd
