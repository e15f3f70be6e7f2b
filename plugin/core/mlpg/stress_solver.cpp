#include "core/mlpg/stress_solver.h"

#include <cmath>
#include <exception>
#include <new>

#include "core/mlpg/nearest_owner.h"
#include "core/mlpg/stress_problem.h"
#include "core/mlpg/weak_form.h"
#include "core/stress/stress_recovery.h"
#include "stopwatch.h"

namespace sherd {
struct StressSolver::Impl {
    std::shared_ptr<const Discretisation> solid;
    StressProblem problem;
    StressRecovery recovery;
    std::unique_ptr<WeakForm> form;
    StressSolverReport report;

    Impl(std::shared_ptr<const Discretisation> sampled, const Material& material,
         const StressSettings& settings)
        : solid(std::move(sampled)),
          problem(*solid, material, settings),
          recovery(*solid, problem.supports, problem.support_radius) {}

    LoadVector noLoads() const {
        LoadVector loads;
        loads.forces.setZero(problem.unknowns());
        loads.resultants.setZero(6, problem.motions.components.count);
        return loads;
    }

    /// Sum of |F|: what net force, and net moment over the size of the body, are measured against.
    static double magnitude(const std::vector<PointForce>& loads) {
        double sum = 0;
        for (const PointForce& load : loads) sum += load.force.norm();
        return sum;
    }

    void recoverStress(const std::vector<Mat3>& cells, const std::vector<Vec3>& points,
                       StressField& field) const {
        recovery.recover(cells, field.particles, field.surface);
        for (const Vec3& point : points)
            field.points.push_back(recovery.recoverAt(cells, point, nearestOwner(problem.solid, point)));
    }

    Result<StressField> solve(LoadVector loads, double load_magnitude, const std::vector<Vec3>& points) const;
};

namespace {

bool isFinite(const std::vector<Voigt>& stresses) {
    for (const Voigt& stress : stresses)
        if (!stress.allFinite()) return false;
    return true;
}

}  // namespace

Result<StressField> StressSolver::Impl::solve(LoadVector loads, double load_magnitude,
                                              const std::vector<Vec3>& points) const {
    const Stopwatch solve_watch;
    form->addInertia(loads);
    const Result<Displacement> solved = form->solve(loads.forces);
    if (!solved) return Error{solved.error()};
    const Displacement& displacement = solved.value();

    StressField field;
    field.solve_ms = solve_watch.milliseconds();
    const Stopwatch recovery_watch;
    recoverStress(displacement.cell_stresses, points, field);
    field.recovery_ms = recovery_watch.milliseconds();
    field.strain_energy_j = 0.5 * displacement.unknowns.dot(loads.forces);
    field.residual_rel = displacement.residual_rel;
    if (load_magnitude > 0)
        field.imbalance_rel = problem.motions.resultants(loads.forces).cwiseAbs().maxCoeff() / load_magnitude;
    field.warnings = report.warnings;
    if (!std::isfinite(field.strain_energy_j) || !isFinite(field.particles) || !isFinite(field.surface) ||
        !isFinite(field.points))
        return Error{
            "The stress came out not finite; the loads or the sampling of the solid are beyond what can be "
            "solved."};
    return field;
}

Result<StressSolver> StressSolver::build(std::shared_ptr<const Discretisation> solid,
                                         const Material& material, const StressSettings& settings) {
    if (Status status = checkStressProblem(solid.get(), material, settings); !status)
        return Error{status.error()};
    try {
        Stopwatch watch;
        auto impl = std::make_unique<Impl>(std::move(solid), material, settings);
        StressSolverReport& report = impl->report;
        report.warnings = trustWarnings(impl->problem, material);
        const bool galerkin = settings.test_function == TestFunction::galerkin;
        Result<std::unique_ptr<WeakForm>> form =
            galerkin ? makeGalerkinForm(impl->problem, report.factor_ms, report.warnings)
                     : makeHeavisideForm(impl->problem, report.factor_ms, report.warnings);
        if (!form) return Error{form.error()};
        impl->form = std::move(form).value();
        report.assemble_ms = watch.milliseconds() - report.factor_ms;
        report.unknowns = static_cast<int>(impl->problem.unknowns());
        report.factor_entries = impl->form->solver().factorEntries();
        return StressSolver(std::move(impl));
    } catch (const std::bad_alloc&) {
        return Error{
            "There is not enough memory for the stress problem of this solid; use a larger particle "
            "spacing."};
    } catch (const std::exception& trouble) {
        return Error{std::string("The stress problem could not be set up: ") + trouble.what()};
    }
}

Result<StressField> StressSolver::solve(const std::vector<PointForce>& point_forces,
                                        const std::vector<Vec3>& points) const {
    const StressProblem& problem = impl_->problem;
    try {
        LoadVector loads = impl_->noLoads();
        ShapeEvaluator evaluator(problem.solid, problem.supports, problem.space);
        ShapeFunctions shapes;
        for (const PointForce& load : point_forces) {
            if (!load.force.allFinite() || !load.position.allFinite())
                return Error{"A load on the body is not finite; check the contact that it came from."};
            const int owner = nearestOwner(problem.solid, load.position);
            const Particle& particle = problem.solid.particles[owner];
            if ((load.position - particle.position).norm() > 3 * particle.spacing)
                return Error{
                    "A load acts more than three particle spacings outside the body; give it in the asset's "
                    "frame."};
            evaluator.evaluate(load.position, owner, false, shapes);
            impl_->form->addLoad(shapes, owner, load, loads);
        }
        return impl_->solve(std::move(loads), Impl::magnitude(point_forces), points);
    } catch (const std::exception& trouble) {
        return Error{std::string("The stress could not be solved: ") + trouble.what()};
    }
}

Result<StressField> StressSolver::solveTraction(
    const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
    const std::vector<Vec3>& points) const {
    const StressProblem& problem = impl_->problem;
    try {
        LoadVector loads = impl_->noLoads();
        ShapeEvaluator evaluator(problem.solid, problem.supports, problem.space);
        ShapeFunctions shapes;
        double magnitude = 0;
        for (const SurfacePoint& point : problem.solid.surface_points) {
            const double area = point.area.norm();
            if (area == 0) continue;
            const PointForce load{point.position, area * traction(point.position, point.area / area)};
            if (!load.force.allFinite()) return Error{"The traction is not finite somewhere on the surface."};
            const int owner = problem.solid.cells[point.cell].particle;
            evaluator.evaluate(point.position, owner, false, shapes);
            impl_->form->addLoad(shapes, owner, load, loads);
            magnitude += load.force.norm();
        }
        return impl_->solve(std::move(loads), magnitude, points);
    } catch (const std::exception& trouble) {
        return Error{std::string("The stress could not be solved: ") + trouble.what()};
    }
}

StressField StressSolver::stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                                   const std::function<Mat3(const Vec3& x)>& gradient) const {
    const StressProblem& problem = impl_->problem;
    Eigen::VectorXd unknowns(problem.unknowns());
    const int block = problem.space.unknownsPerParticle();
    for (size_t i = 0; i < problem.solid.particles.size(); ++i) {
        const Particle& particle = problem.solid.particles[i];
        const long row = static_cast<long>(i) * block;
        unknowns.segment<3>(row) = displacement(particle.position);
        if (block == 3) continue;
        const Mat3 scaled = particle.spacing * gradient(particle.position);
        for (int j = 0; j < 3; ++j) unknowns.segment<3>(row + 3 + 3 * j) = scaled.col(j);
    }
    StressField field;
    impl_->recoverStress(cellStresses(problem, unknowns), {}, field);
    return field;
}

const StressSolverReport& StressSolver::report() const {
    return impl_->report;
}

StressSolver::StressSolver(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StressSolver::StressSolver(StressSolver&&) noexcept = default;
StressSolver& StressSolver::operator=(StressSolver&&) noexcept = default;
StressSolver::~StressSolver() = default;

}  // namespace sherd
