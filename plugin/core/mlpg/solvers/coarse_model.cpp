#include "core/mlpg/solvers/coarse_model.h"

#include <cmath>

#include "core/numerics/parallel_chunks.h"
#include "core/sampling/sample_solid.h"

namespace sherd {

namespace {

constexpr Basis basis = Basis::quadratic;
constexpr int order = 2 * splineDegree(basis);
constexpr int cells_per_spacing = 3;  // tells prongs apart that lie in one cell
constexpr double doubtful_condition = 1e-10;

}  // namespace

CoarseModel::CoarseModel(std::shared_ptr<const SplineProblem> problem, PinnedSystem system)
    : problem_(std::move(problem)), system_(std::move(system)) {}

Result<CoarseModel> CoarseModel::make(const TriangleMesh& surface, double spacing_m, const Material& material,
                                      const std::vector<SupportPoint>& supports) {
    const OnThisThreadAlone small_work;
    Result<CellParts> parts = sampleParts(surface, spacing_m, cells_per_spacing, order, MomentRule::quick);
    if (!parts) return Error{parts.error()};
    const auto solid = std::make_shared<Discretisation>();
    solid->spacing = spacing_m;
    solid->parts = std::move(parts).value();
    Result<SplineProblem> problem = makeSplineProblem(solid, material, basis, supports, {});
    if (!problem) return Error{problem.error()};
    BlockMatrix stiffness = stiffnessOf(problem.value());
    Result<PinnedSystem> system = PinnedSystem::factor(stiffness, pinnedUnknowns(problem.value(), stiffness),
                                                       problem.value().space->highest_cells);
    if (!system) return Error{system.error()};
    const SparseSolver& factor = system.value().solver();
    if (factor.relativeShift() > 0 || factor.reciprocalCondition() < doubtful_condition)
        return Error{"The stiffness of the coarse model is nearly singular; a full solve has to tell."};
    return CoarseModel(std::make_shared<const SplineProblem>(std::move(problem).value()),
                       std::move(system).value());
}

Result<double> CoarseModel::strainEnergy(const std::vector<PointForce>& loads) const {
    const OnThisThreadAlone small_work;
    Result<Eigen::VectorXd> loaded = forcesAt(*problem_, loads);
    if (!loaded) return Error{loaded.error()};
    Eigen::VectorXd& forces = loaded.value();
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants = problem_->motions.resultants(forces);
    clearHeld(*problem_, resultants);
    (void)problem_->inertia.balance(forces, resultants, problem_->motions);
    Eigen::VectorXd held = forces, unknowns;
    for (const int unknown : system_.pinned()) held[unknown] = 0;
    if (!system_.solver().solve(held, unknowns)) return Error{"The coarse solve failed."};
    const double energy = 0.5 * unknowns.dot(forces);
    if (!(energy >= 0) || !std::isfinite(energy)) return Error{"The coarse solve gives no energy."};
    return energy;
}

}  // namespace sherd
