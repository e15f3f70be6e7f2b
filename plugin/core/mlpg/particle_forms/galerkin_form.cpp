#include "core/mlpg/inertia_relief.h"
#include "core/mlpg/particle_forms/galerkin_stiffness.h"
#include "core/mlpg/particle_forms/weak_form.h"
#include "core/numerics/stopwatch.h"

namespace sherd {
namespace {

/// Test functions are the trial functions. The rigid motions are removed by holding six unknowns a component
/// at zero, which carries no reaction because the loads are balanced.
class GalerkinForm : public WeakForm {
  public:
    GalerkinForm(const StressProblem& problem, std::unique_ptr<SparseSolver> solver, std::vector<int> pinned)
        : problem_(problem),
          solver_(std::move(solver)),
          pinned_(std::move(pinned)),
          inertia_(InertiaRelief::galerkin(problem.solid, problem.supports, problem.space, problem.cells,
                                           problem.motions)) {}

    void addLoad(const ShapeFunctions& shapes, int, const PointForce& load,
                 LoadVector& loads) const override {
        const int functions = problem_.space.functionsPerParticle();
        for (size_t n = 0; n < shapes.values.size(); ++n) {
            const long function =
                static_cast<long>(shapes.particles[n / functions]) * functions + n % functions;
            loads.forces.segment<3>(3 * function) += shapes.values[n] * load.force;
        }
    }

    void addInertia(LoadVector& loads) const override {
        loads.resultants = problem_.motions.resultants(loads.forces);
        inertia_.balance(loads.forces, loads.resultants, problem_.motions);
    }

    /// The residual is taken without K: from the stresses of the cells and the forces that balance them.
    Result<Displacement> solve(const Eigen::VectorXd& forces) const override {
        // Refinement mends what the factorisation lost to a shifted diagonal or a bad condition; mostly it
        // never runs.
        constexpr double good_residual = 1e-12;
        constexpr int largest_refinements = 5;
        Displacement best;
        best.unknowns.setZero(forces.size());
        best.cell_stresses.assign(problem_.solid.cells.size(), Mat3::Zero());
        const double scale = forces.norm();
        if (scale == 0) return best;
        best.residual_rel = 1;
        Eigen::VectorXd residual = forces, correction;
        for (int step = 0; step <= largest_refinements && best.residual_rel > good_residual; ++step) {
            for (int unknown : pinned_) residual[unknown] = 0;
            if (!solver_->solve(residual, correction))
                return Error{"The stress solve failed in the linear solver."};
            Displacement next{best.unknowns + correction, {}, 0};
            next.cell_stresses = cellStresses(problem_, next.unknowns);
            residual =
                forces - internalForces(problem_.solid, problem_.cells, next.cell_stresses, forces.size());
            next.residual_rel = residual.norm() / scale;
            if (step > 0 && !(next.residual_rel < best.residual_rel)) break;
            best = std::move(next);
        }
        return best;
    }

    const SparseSolver& solver() const override { return *solver_; }

  private:
    const StressProblem& problem_;
    std::unique_ptr<SparseSolver> solver_;
    std::vector<int> pinned_;
    InertiaRelief inertia_;
};

}  // namespace

Result<std::unique_ptr<WeakForm>> makeGalerkinForm(const StressProblem& problem, double& factor_ms,
                                                   std::vector<std::string>& warnings) {
    SparseMatrix stiffness = galerkinStiffness(problem.solid, problem.cells, problem.elasticity);
    std::vector<int> pinned = unknownsToPin(problem.motions);
    pinUnknowns(stiffness, pinned);
    Stopwatch watch;
    Result<std::unique_ptr<SparseSolver>> solver =
        factorCholesky(stiffness, problem.space.unknownsPerParticle());
    factor_ms = watch.milliseconds();
    if (!solver) return Error{solver.error()};
    if (solver.value()->relativeShift() > 0)
        warnings.push_back(
            "The stiffness matrix is singular beyond the rigid motions, and a small stiffness was added to "
            "every "
            "unknown; use more integration cells per spacing (2 or more), or another spacing or support "
            "radius.");
    return std::unique_ptr<WeakForm>(
        std::make_unique<GalerkinForm>(problem, std::move(solver).value(), std::move(pinned)));
}

}  // namespace sherd
