#include <cmath>
#include <exception>

#include "core/mlpg/particle_forms/stress_recovery.h"
#include "core/mlpg/particle_forms/weak_form.h"
#include "core/mlpg/stress_solver_impl.h"
#include "core/numerics/stopwatch.h"
#include "core/sampling/nearest_owner.h"

namespace sherd {
namespace {

class ParticleSolver : public StressSolver::Impl {
  public:
    ParticleSolver(std::shared_ptr<const Discretisation> sampled, const Material& material,
                   const StressSettings& settings)
        : solid(std::move(sampled)),
          problem(*solid, material, settings),
          recovery(*solid, problem.supports, problem.support_radius) {}

    Result<StressField> solve(const std::vector<PointForce>& loads, const std::vector<Vec3>& points,
                              const Vec3& spin_rad_s) const override;
    Result<StressField> solveTraction(
        const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
        const std::vector<Vec3>& points) const override;
    StressField stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                         const std::function<Mat3(const Vec3& x)>& gradient) const override;

    std::shared_ptr<const Discretisation> solid;
    StressProblem problem;
    StressRecovery recovery;
    std::unique_ptr<WeakForm> form;

  private:
    LoadVector noLoads() const {
        LoadVector loads;
        loads.forces.setZero(problem.unknowns());
        loads.resultants.setZero(6, problem.motions.componentCount());
        return loads;
    }

    /// Sum of |F|, which the net force, and the net moment over the size of the body, are compared with.
    static double magnitude(const std::vector<PointForce>& loads) {
        double sum = 0;
        for (const PointForce& load : loads) sum += load.force.norm();
        return sum;
    }

    void recoverStress(const std::vector<Mat3>& cells, const std::vector<Vec3>& points,
                       StressField& field) const {
        recovery.recover(cells, field.particles, field.surface);
        field.point_spacing_m.assign(points.size(), problem.solid.spacing);
        for (const Vec3& point : points)
            field.points.push_back(recovery.recoverAt(cells, point, nearestOwner(problem.solid, point)));
    }

    Result<StressField> solve(LoadVector loads, double load_magnitude, const std::vector<Vec3>& points) const;
};

Result<StressField> ParticleSolver::solve(LoadVector loads, double load_magnitude,
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
    return finiteOrError(std::move(field));
}

Result<StressField> ParticleSolver::solve(const std::vector<PointForce>& point_forces,
                                          const std::vector<Vec3>& points, const Vec3& spin_rad_s) const {
    if (spin_rad_s.norm() > 0)
        return Error{"Inertia loads of a spin are there for spline trial functions only."};
    try {
        LoadVector loads = noLoads();
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
            form->addLoad(shapes, owner, load, loads);
        }
        return solve(std::move(loads), magnitude(point_forces), points);
    } catch (const std::exception& trouble) {
        return Error{std::string("The stress could not be solved: ") + trouble.what()};
    }
}

Result<StressField> ParticleSolver::solveTraction(
    const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
    const std::vector<Vec3>& points) const {
    try {
        LoadVector loads = noLoads();
        ShapeEvaluator evaluator(problem.solid, problem.supports, problem.space);
        ShapeFunctions shapes;
        double total = 0;
        for (const SurfacePoint& point : problem.solid.surface_points) {
            const double area = point.area.norm();
            if (area == 0) continue;
            const PointForce load{point.position, area * traction(point.position, point.area / area)};
            if (!load.force.allFinite()) return Error{"The traction is not finite somewhere on the surface."};
            const int owner = problem.solid.cells[point.cell].particle;
            evaluator.evaluate(point.position, owner, false, shapes);
            form->addLoad(shapes, owner, load, loads);
            total += load.force.norm();
        }
        return solve(std::move(loads), total, points);
    } catch (const std::exception& trouble) {
        return Error{std::string("The stress could not be solved: ") + trouble.what()};
    }
}

StressField ParticleSolver::stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                                     const std::function<Mat3(const Vec3& x)>& gradient) const {
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
    recoverStress(cellStresses(problem, unknowns), {}, field);
    return field;
}

}  // namespace

Result<std::unique_ptr<StressSolver::Impl>> StressSolver::Impl::overParticles(
    std::shared_ptr<const Discretisation> solid, const Material& material, const StressSettings& settings) {
    Stopwatch watch;
    auto solver = std::make_unique<ParticleSolver>(std::move(solid), material, settings);
    StressSolverReport& report = solver->report;
    report.warnings = trustWarnings(solver->problem, material);
    const bool galerkin = settings.test_function == TestFunction::galerkin;
    Result<std::unique_ptr<WeakForm>> form =
        galerkin
            ? makeGalerkinForm(solver->problem, report.factor_ms, report.warnings)
            : makeHeavisideForm(solver->problem, settings.test_function, report.factor_ms, report.warnings);
    if (!form) return Error{form.error()};
    solver->form = std::move(form).value();
    report.assemble_ms = watch.milliseconds() - report.factor_ms;
    report.unknowns = static_cast<int>(solver->problem.unknowns());
    const SparseSolver& factor = solver->form->solver();
    report.factor_entries = factor.factorEntries();
    report.factor_bytes = factor.factorBytes();
    report.reciprocal_condition = factor.reciprocalCondition();
    return std::unique_ptr<Impl>(std::move(solver));
}

}  // namespace sherd
