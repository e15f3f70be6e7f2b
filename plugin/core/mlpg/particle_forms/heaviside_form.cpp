#include "core/mlpg/particle_forms/heaviside_stiffness.h"
#include "core/mlpg/particle_forms/lu_solver.h"
#include "core/mlpg/particle_forms/particle_inertia.h"
#include "core/mlpg/particle_forms/weak_form.h"
#include "core/numerics/stopwatch.h"

namespace sherd {
namespace {

/// MLPG5: the test function is 1 on a sub-domain, so that each row says that the forces on a sub-domain
/// balance.
class HeavisideForm : public WeakForm {
  public:
    HeavisideForm(const StressProblem& problem, std::shared_ptr<const SparseMatrix> matrix,
                  std::unique_ptr<SparseSolver> solver)
        : problem_(problem),
          matrix_(std::move(matrix)),
          solver_(std::move(solver)),
          inertia_(heavisideInertia(problem)) {}

    void addLoad(const ShapeFunctions&, int owner, const PointForce& load, LoadVector& loads) const override {
        const int component = problem_.motions.component_of_node[owner];
        loads.forces.segment<3>(3L * owner) += load.force;
        loads.resultants.col(component) +=
            problem_.motions.at(load.position, component).transpose() * load.force;
    }

    void addInertia(LoadVector& loads) const override {
        inertia_.balance(loads.forces, loads.resultants, problem_.motions);
    }

    Result<Displacement> solve(const Eigen::VectorXd& forces) const override {
        const double scale = forces.norm();
        if (scale == 0) return displacement(Eigen::VectorXd::Zero(forces.size()), 0);
        Eigen::VectorXd bordered =
            Eigen::VectorXd::Zero(forces.size() + 6L * problem_.motions.componentCount());
        bordered.head(forces.size()) = forces;
        Eigen::VectorXd solution;
        if (!solver_->solve(bordered, solution))
            return Error{"The stress solve failed in the linear solver."};
        const double residual = (bordered - product(*matrix_, solution)).norm() / scale;
        return displacement(solution.head(forces.size()), residual);
    }

    const SparseSolver& solver() const override { return *solver_; }

  private:
    Displacement displacement(Eigen::VectorXd unknowns, double residual_rel) const {
        std::vector<Mat3> stresses = cellStresses(problem_, unknowns);
        return {std::move(unknowns), std::move(stresses), residual_rel};
    }

    const StressProblem& problem_;
    std::shared_ptr<const SparseMatrix> matrix_;
    std::unique_ptr<SparseSolver> solver_;
    InertiaRelief inertia_;
};

}  // namespace

Result<std::unique_ptr<WeakForm>> makeHeavisideForm(const StressProblem& problem, TestFunction test,
                                                    double& factor_ms, std::vector<std::string>& warnings) {
    const bool paper = test == TestFunction::heaviside_paper;
    const auto matrix = std::make_shared<const SparseMatrix>(heavisideStiffness(
        paper ? fluxThroughCubes(problem) : fluxThroughSharedFaces(problem), problem.solid, problem.motions));
    Stopwatch watch;
    Result<std::unique_ptr<SparseSolver>> solver = factorLu(matrix);
    factor_ms = watch.milliseconds();
    if (!solver) return Error{solver.error()};
    warnings.push_back(
        "Heaviside test functions balance forces but not moments: bending stress comes out too low where "
        "fewer than "
        "about eight particles lie across the thickness; galerkin test functions have no such limit.");
    if (paper)
        warnings.push_back(
            "The sub-domains of heaviside_paper are whole cubes of the grid: on bodies that the grid does "
            "not fit, "
            "stress near the surface is wrong; heaviside test functions follow the surface.");
    return std::unique_ptr<WeakForm>(
        std::make_unique<HeavisideForm>(problem, matrix, std::move(solver).value()));
}

}  // namespace sherd
