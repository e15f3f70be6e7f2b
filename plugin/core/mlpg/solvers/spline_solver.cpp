#include <algorithm>
#include <cmath>
#include <optional>

#include "core/linear_algebra/block_product.h"
#include "core/mlpg/pinned_system.h"
#include "core/mlpg/reduced/hot_places.h"
#include "core/mlpg/reduced/make_peak_table.h"
#include "core/mlpg/reduced/reduced_stress.h"
#include "core/mlpg/splines/contact_remainder.h"
#include "core/mlpg/splines/resampling.h"
#include "core/mlpg/splines/stress_reading.h"
#include "core/mlpg/stress_solver_impl.h"
#include "core/numerics/stopwatch.h"

namespace sherd {
namespace {

/// Galerkin on splines.
class SplineSolver : public StressSolver::Impl {
  public:
    SplineSolver(std::shared_ptr<const SplineProblem> problem, BlockMatrix stiffness, PinnedSystem system,
                 Resampling resampling, const Material& material)
        : shared_problem_(std::move(problem)),
          problem_(*shared_problem_),
          stiffness_(std::move(stiffness)),
          system_(std::move(system)),
          resampling_(std::move(resampling)),
          material_(material),
          samples_(locateSamples(*problem_.solid)),
          reading_points_(*problem_.solid, samples_),
          faces_(reading_points_) {}

    Result<StressField> solve(const std::vector<PointForce>& loads, const std::vector<Vec3>& points,
                              const Vec3& spin_rad_s) const override;
    Result<double> strainEnergy(const std::vector<PointForce>& loads) const override;
    Result<StressField> solveContact(const ContactField& contact) const override;
    Result<StressField> stressOfUnknowns(const Eigen::VectorXd& unknowns,
                                         const ContactField& contact) const override;
    Result<StressField> solveTraction(
        const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
        const std::vector<Vec3>& points) const override;
    StressField stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                         const std::function<Mat3(const Vec3& x)>& gradient) const override;
    Result<std::shared_ptr<const ReducedStress>> reduced(const Progress& progress) const override;

  private:
    Result<PinnedSystem::Solution> solveForces(const Eigen::VectorXd& forces,
                                               double good_residual = 1e-10) const;
    Result<PinnedSystem::Solution> solveBalanced(Eigen::VectorXd& forces, double good_residual = 1e-10) const;
    double imbalance(const Eigen::VectorXd& forces, double magnitude) const;

    std::shared_ptr<const SplineProblem> shared_problem_;
    const SplineProblem& problem_;
    BlockMatrix stiffness_;
    PinnedSystem system_;
    Resampling resampling_;
    Material material_;
    std::vector<GridPoint> samples_;
    ReadingPoints reading_points_;
    SurfaceFaces faces_;
};

Result<PinnedSystem::Solution> SplineSolver::solveForces(const Eigen::VectorXd& forces,
                                                         double good_residual) const {
    const auto residual_of = [&](const Eigen::VectorXd& unknowns) -> Eigen::VectorXd {
        return forces - blockProduct(stiffness_, unknowns);
    };
    return system_.solve(forces, residual_of, good_residual);
}

/// Net force and moment of what should be balanced, over the sum of all forces.
double SplineSolver::imbalance(const Eigen::VectorXd& forces, double magnitude) const {
    if (!(magnitude > 0)) return 0;
    Eigen::Matrix<double, 6, Eigen::Dynamic> left = problem_.motions.resultants(forces);
    clearHeld(problem_, left);
    return left.cwiseAbs().maxCoeff() / magnitude;
}

Result<StressField> SplineSolver::solve(const std::vector<PointForce>& loads, const std::vector<Vec3>& points,
                                        const Vec3& spin_rad_s) const {
    const Stopwatch watch;
    Result<Eigen::VectorXd> loaded = forcesAt(problem_, loads);
    if (!loaded) return Error{loaded.error()};
    Eigen::VectorXd& forces = loaded.value();
    double magnitude = 0;
    for (const PointForce& load : loads) magnitude += load.force.norm();
    const Mat3 spin_force = spinForce(spin_rad_s, problem_.density_kg_m3);
    if (spin_rad_s.norm() > 0) magnitude += addSpin(spin_force, problem_.inertia_moments, forces);
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants = problem_.motions.resultants(forces);
    clearHeld(problem_, resultants);
    const auto acceleration = problem_.inertia.balance(forces, resultants, problem_.motions);

    const Result<PinnedSystem::Solution> solved = solveForces(forces);
    if (!solved) return Error{solved.error()};
    const Eigen::VectorXd& unknowns = solved.value().unknowns;
    const SplineField whole = problem_.fieldOf(unknowns);
    const BodyLoads acting{loads, inertiaForces(*problem_.space, problem_.motions, acceleration, spin_force)};
    const Result<std::vector<Zoom>> zooms = resampling_.resample(problem_, whole, acting);
    if (!zooms) return Error{zooms.error()};

    StressField field;
    for (const Zoom& zoom : zooms.value()) field.resampling_entries += zoom.stiffness_entries;
    field.solve_ms = watch.milliseconds();
    const Stopwatch recovery_watch;
    readStress(problem_, samples_, whole, zooms.value(), points, field);
    field.recovery_ms = recovery_watch.milliseconds();
    field.strain_energy_j = 0.5 * unknowns.dot(forces);
    field.residual_rel = solved.value().residual_rel;
    field.imbalance_rel = imbalance(forces, magnitude);
    field.warnings = report.warnings;
    constexpr double largest_good_residual = 1e-6;
    if (!(field.residual_rel < largest_good_residual))
        field.warnings.push_back("The linear solve left a residual of " + std::to_string(field.residual_rel) +
                                 " of the load; do the supports hold the body well?");
    return finiteOrError(std::move(field));
}

/// Of forces that the rigid acceleration has to balance, which is added to them.
Result<PinnedSystem::Solution> SplineSolver::solveBalanced(Eigen::VectorXd& forces,
                                                           double good_residual) const {
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants = problem_.motions.resultants(forces);
    clearHeld(problem_, resultants);
    problem_.inertia.balance(forces, resultants, problem_.motions);
    return solveForces(forces, good_residual);
}

Result<double> SplineSolver::strainEnergy(const std::vector<PointForce>& loads) const {
    Result<Eigen::VectorXd> forces = forcesAt(problem_, loads);
    if (!forces) return Error{forces.error()};
    constexpr double good_residual = 1e-4;  // the error of the energy is its square
    const Result<PinnedSystem::Solution> solved = solveBalanced(forces.value(), good_residual);
    if (!solved) return Error{solved.error()};
    const double energy = 0.5 * solved.value().unknowns.dot(forces.value());
    if (!std::isfinite(energy)) return Error{"The strain energy came out not finite."};
    return energy;
}

std::vector<Vec3> positionsOf(const std::vector<SurfacePlace>& places) {
    std::vector<Vec3> positions;
    for (const SurfacePlace& place : places) positions.push_back(place.position);
    return positions;
}

Result<StressField> SplineSolver::solveContact(const ContactField& contact) const {
    const Stopwatch watch;
    Result<Eigen::VectorXd> loaded = contactRemainder(problem_, reading_points_, faces_, contact);
    if (!loaded) return Error{loaded.error()};
    const Result<PinnedSystem::Solution> solved = solveBalanced(loaded.value());
    if (!solved) return Error{solved.error()};
    StressField field;
    field.solve_ms = watch.milliseconds();
    const Stopwatch recovery_watch;
    readStress(problem_, samples_, problem_.fieldOf(solved.value().unknowns), {}, positionsOf(contact.places),
               field);
    addNearField(*problem_.solid, contact, problem_.elasticity, field);
    field.recovery_ms = recovery_watch.milliseconds();
    field.residual_rel = solved.value().residual_rel;
    field.warnings = report.warnings;
    return finiteOrError(std::move(field));
}

Result<StressField> SplineSolver::stressOfUnknowns(const Eigen::VectorXd& unknowns,
                                                   const ContactField& contact) const {
    if (unknowns.size() != 3L * problem_.space->function_count)
        return Error{"The unknowns are those of another stress problem."};
    StressField field;
    readStress(problem_, samples_, problem_.fieldOf(unknowns), {}, positionsOf(contact.places), field);
    ContactField clear{{}, contact.places, contact.others};  // of tractions
    for (SurfacePlace& place : clear.places) place.unresolved.setZero();
    addNearField(*problem_.solid, clear, problem_.elasticity, field);
    return finiteOrError(std::move(field));
}

Result<StressField> SplineSolver::solveTraction(
    const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
    const std::vector<Vec3>& points) const {
    std::vector<PointForce> loads;
    for (const SurfacePoint& point : problem_.solid->surface_points) {
        const double area = point.area.norm();
        if (area > 0) loads.push_back({point.position, area * traction(point.position, point.area / area)});
    }
    return solve(loads, points, Vec3::Zero());
}

StressField SplineSolver::stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                                   const std::function<Mat3(const Vec3& x)>&) const {
    const SplineSpace& space = *problem_.space;
    Eigen::VectorXd unknowns(3L * space.function_count);
    for (int f = 0; f < space.function_count; ++f)
        unknowns.segment<3>(3L * f) = displacement(space.greville_points[f]);
    StressField field;
    readStress(problem_, samples_, problem_.fieldOf(unknowns), {}, {}, field);
    return field;
}

Result<std::shared_ptr<const ReducedStress>> SplineSolver::reduced(const Progress& progress) const {
    if (!problem_.shares.empty()) return Error{"A damaged solid has no reduced model."};
    const auto tell = [&](double done) {
        if (progress) progress(done);
    };
    tell(0);
    // A thousand solves in double precision take less than as many that are refined.
    std::optional<PinnedSystem> precise;
    if (system_.solver().isSingle()) {
        BlockMatrix stiffness = stiffness_;  // others may solve with it now
        auto made = PinnedSystem::factor(stiffness, system_.pinned(), problem_.space->highest_cells);
        if (!made) return Error{made.error()};
        precise = std::move(made).value();
    }
    const SparseSolver& factor = precise ? precise->solver() : system_.solver();
    if (factor.relativeShift() > 0)
        return Error{"The stiffness matrix is singular, so it has no reduced model; try another spacing."};
    const ReducedModelLimits limits;
    const auto patches = unitPatches(*problem_.solid, limits.patches);
    constexpr double solves_done = 0.4, modes_done = 0.6;  // about: shares of the time
    const auto unit = unitResponses(problem_, factor, system_.pinned(), patches,
                                    [&](double done) { tell(solves_done * done); });
    if (!unit) return Error{unit.error()};
    const bool is_direct = 3 * problem_.space->function_count <= limits.direct_unknowns;
    auto model = is_direct ? ReducedModel::makeDirect(shared_problem_, factor, system_.pinned(), unit.value())
                           : ReducedModel::make(shared_problem_, stiffness_, unit.value(), limits);
    if (!model) return Error{model.error()};
    model.value().keepHotPlaces(hotPlaces(
        model.value(), [&](const Eigen::VectorXd& unknowns) { return stressOfUnknowns(unknowns, {}); }));
    tell(modes_done);
    // Beside a support, stress and compliance change too fast from place to place for a table.
    const bool is_held =
        std::any_of(problem_.held.begin(), problem_.held.end(), [](char held) { return held; });
    Result<PeakTable> peaks = PeakTable{};
    if (!is_held)
        peaks =
            makePeakTable({problem_, factor, system_.pinned(), patches, unit.value(), model.value().modes()},
                          samples_, material_);
    if (!peaks) return Error{peaks.error()};
    tell(1);
    return std::shared_ptr<const ReducedStress>(new ReducedStress{std::move(model).value(),
                                                                  DamageReading(shared_problem_, samples_),
                                                                  std::move(peaks).value(), report.warnings});
}

std::vector<std::string> trustWarnings(const SparseSolver& factor) {
    std::vector<std::string> warnings;
    if (factor.relativeShift() > 0)
        warnings.push_back(
            "The stiffness matrix is singular beyond the rigid motions, and a small stiffness was added to "
            "every unknown; try another spacing.");
    return warnings;
}

}  // namespace

Result<std::unique_ptr<StressSolver::Impl>> StressSolver::Impl::overSplines(
    std::shared_ptr<const Discretisation> solid, const Material& material, const StressSettings& settings,
    const std::vector<SupportPoint>& supports, const std::vector<char>& damaged, Precision precision) {
    Result<SplineProblem> problem =
        makeSplineProblem(std::move(solid), material, settings.basis, supports, damaged);
    if (!problem) return Error{problem.error()};
    const Stopwatch assembly_watch;
    BlockMatrix stiffness = stiffnessOf(problem.value());
    StressSolverReport report;
    report.assemble_ms = assembly_watch.milliseconds();
    const Stopwatch factor_watch;
    Result<PinnedSystem> system = PinnedSystem::factor(stiffness, pinnedUnknowns(problem.value(), stiffness),
                                                       problem.value().space->highest_cells, precision);
    if (!system) return Error{system.error()};
    report.factor_ms = factor_watch.milliseconds();
    const SparseSolver& factor = system.value().solver();
    report.unknowns = stiffness.size();
    report.factor_entries = factor.factorEntries();
    report.factor_bytes = factor.factorBytes();
    report.reciprocal_condition = factor.reciprocalCondition();
    report.warnings = trustWarnings(factor);
    // Zooms know whole material only.
    const ResamplingReach reach{damaged.empty() ? settings.resampling_rounds : 0, settings.resampling_margin,
                                settings.resampling_cells, settings.resampling_error};
    const auto shared = std::make_shared<const SplineProblem>(std::move(problem).value());
    constexpr int of_factor = 2;  // what finer grids at high stress may store, times the factor
    const Stopwatch resampling_watch;
    Resampling resampling(*shared, reach, of_factor * report.factor_entries);
    report.assemble_ms += resampling_watch.milliseconds();
    auto solver = std::make_unique<SplineSolver>(shared, std::move(stiffness), std::move(system).value(),
                                                 std::move(resampling), material);
    solver->report = std::move(report);
    return std::unique_ptr<Impl>(std::move(solver));
}

}  // namespace sherd
