#pragma once

#include <sherd/result.h>

#include <memory>
#include <string>
#include <vector>

#include "core/linear_algebra/sparse_solver.h"
#include "core/mlpg/particle_forms/stress_problem.h"

namespace sherd {

/// Loads of one blow as right-hand side of K u = f.
struct LoadVector {
    Eigen::VectorXd forces;  ///< #unknowns
    /// Of the loads alone, 6 x #components, as RigidMotions.
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants;
};

struct Displacement {
    Eigen::VectorXd unknowns;
    std::vector<Mat3> cell_stresses;  ///< #cells, Pa
    double residual_rel = 0;          ///< |K u - f| / |f|
};

/// A choice of test functions: K factored, with its treatment of the rigid motions, and its way to turn loads
/// into f.
class WeakForm {
  public:
    virtual ~WeakForm() = default;

    /// Adds a point force inside the sub-domain of particle `owner`; `shapes` are evaluated where it acts.
    virtual void addLoad(const ShapeFunctions& shapes, int owner, const PointForce& load,
                         LoadVector& loads) const = 0;

    /// Adds the rigid accelerations that balance the loads, component by component.
    virtual void addInertia(LoadVector& loads) const = 0;

    virtual Result<Displacement> solve(const Eigen::VectorXd& forces) const = 0;

    virtual const SparseSolver& solver() const = 0;
};

/// `problem` must outlive the form. Sentences that limit trust in the form are added to `warnings`;
/// `factor_ms` is set. `test` is one of the Heaviside functions.
Result<std::unique_ptr<WeakForm>> makeGalerkinForm(const StressProblem& problem, double& factor_ms,
                                                   std::vector<std::string>& warnings);
Result<std::unique_ptr<WeakForm>> makeHeavisideForm(const StressProblem& problem, TestFunction test,
                                                    double& factor_ms, std::vector<std::string>& warnings);

}  // namespace sherd
