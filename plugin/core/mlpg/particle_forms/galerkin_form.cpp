#include "core/mlpg/particle_forms/cell_strains.h"
#include "core/mlpg/particle_forms/galerkin_stiffness.h"
#include "core/mlpg/particle_forms/particle_inertia.h"
#include "core/mlpg/particle_forms/weak_form.h"
#include "core/mlpg/pinned_system.h"
#include "core/mlpg/pinned_unknowns.h"
#include "core/numerics/stopwatch.h"

namespace sherd {
namespace {

/// Test functions are the trial functions.
class GalerkinForm : public WeakForm {
  public:
    GalerkinForm(const StressProblem& problem, PinnedSystem system)
        : problem_(problem), system_(std::move(system)), inertia_(galerkinInertia(problem)) {}

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
        constexpr double good_residual = 1e-12;
        const auto residual_of = [&](const Eigen::VectorXd& unknowns) -> Eigen::VectorXd {
            return forces - internalForces(problem_.solid, problem_.cells, cellStresses(problem_, unknowns),
                                           forces.size());
        };
        Result<PinnedSystem::Solution> solved = system_.solve(forces, residual_of, good_residual);
        if (!solved) return Error{solved.error()};
        PinnedSystem::Solution& solution = solved.value();
        std::vector<Mat3> stresses = cellStresses(problem_, solution.unknowns);
        return Displacement{std::move(solution.unknowns), std::move(stresses), solution.residual_rel};
    }

    const SparseSolver& solver() const override { return system_.solver(); }

  private:
    const StressProblem& problem_;
    PinnedSystem system_;
    InertiaRelief inertia_;
};

/// The cells that particles lie in.
std::vector<Eigen::Vector3i> placesOf(const Discretisation& solid) {
    std::vector<Eigen::Vector3i> places;
    for (const Particle& particle : solid.particles)
        places.push_back(
            ((particle.position - solid.grid_origin) / solid.spacing).array().floor().cast<int>());
    return places;
}

}  // namespace

Result<std::unique_ptr<WeakForm>> makeGalerkinForm(const StressProblem& problem, double& factor_ms,
                                                   std::vector<std::string>& warnings) {
    BlockMatrix stiffness = galerkinStiffness(problem.solid, problem.cells, problem.elasticity);
    std::vector<int> pinned = unknownsToPin(problem.motions, stiffness);
    Stopwatch watch;
    Result<PinnedSystem> system = PinnedSystem::factor(stiffness, std::move(pinned), placesOf(problem.solid));
    factor_ms = watch.milliseconds();
    if (!system) return Error{system.error()};
    if (system.value().solver().relativeShift() > 0)
        warnings.push_back(
            "The stiffness matrix is singular beyond the rigid motions, and a small stiffness was added to "
            "every unknown; use more integration cells per spacing (2 or more), or another spacing or "
            "support radius.");
    return std::unique_ptr<WeakForm>(std::make_unique<GalerkinForm>(problem, std::move(system).value()));
}

}  // namespace sherd
