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

    int unknowns() const { return stiffness_.size; }

    /// K + shift M.
    Result<std::unique_ptr<SparseSolver>> shifted(double shift) const {
        SparseMatrix sum = stiffness_;
        for (int column = 0; column < sum.size; ++column)
            for (int k = sum.starts[column]; k < sum.starts[column + 1]; ++k) {
                const int row = sum.indices[k];
                if (row % 3 != column % 3) continue;
                const auto begin = mass_.indices.begin() + mass_.starts[column / 3];
                const auto end = mass_.indices.begin() + mass_.starts[column / 3 + 1];
                const auto at = std::lower_bound(begin, end, row / 3);
                if (at != end && *at == row / 3)
                    sum.values[k] += shift * mass_.values[at - mass_.indices.begin()];
            }
        return factorCholesky(sum, 3);
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
    SparseMatrix stiffness_, mass_;
};

}  // namespace sherd
