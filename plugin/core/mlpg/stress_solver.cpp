#include "core/mlpg/stress_solver.h"

#include <cmath>
#include <exception>
#include <new>

#include "core/mlpg/problem_checks.h"
#include "core/mlpg/stress_solver_impl.h"

namespace sherd {
namespace {

bool isFinite(const std::vector<SymmetricTensor>& stresses) {
    for (const SymmetricTensor& stress : stresses)
        if (!stress.allFinite()) return false;
    return true;
}

/// Calls `work` and makes a sentence of what it throws: nothing may leave through Bullet's step.
template <class Value, class Work>
Result<Value> guarded(const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Error{
            "There is not enough memory for the stress problem of this solid; use a larger particle "
            "spacing."};
    } catch (const std::exception& trouble) {
        return Error{std::string("The stress could not be solved: ") + trouble.what()};
    }
}

}  // namespace

Result<StressField> finiteOrError(StressField field) {
    if (!std::isfinite(field.strain_energy_j) || !isFinite(field.particles) || !isFinite(field.surface) ||
        !isFinite(field.points))
        return Error{
            "The stress came out not finite; the loads or the sampling of the solid are beyond what can be "
            "solved."};
    return field;
}

Result<StressSolver> StressSolver::build(std::shared_ptr<const Discretisation> solid,
                                         const Material& material, const StressSettings& settings,
                                         const std::vector<SupportPoint>& supports,
                                         const std::vector<char>& damaged, Precision precision) {
    if (Status status = checkStressProblem(solid.get(), material, settings); !status)
        return Error{status.error()};
    const bool splines = settings.trial_function == TrialFunction::spline;
    if (!splines && !supports.empty()) return Error{"Supports are there for spline trial functions only."};
    if (!splines && !damaged.empty())
        return Error{"Damaged particles are left out of the stress with spline trial functions only."};
    return guarded<StressSolver>([&]() -> Result<StressSolver> {
        Result<std::unique_ptr<Impl>> impl =
            splines ? Impl::overSplines(std::move(solid), material, settings, supports, damaged, precision)
                    : Impl::overParticles(std::move(solid), material, settings);
        if (!impl) return Error{impl.error()};
        return StressSolver(std::move(impl).value());
    });
}

Result<StressField> StressSolver::solve(const std::vector<PointForce>& loads, const std::vector<Vec3>& points,
                                        const Vec3& spin_rad_s) const {
    return guarded<StressField>([&] { return impl_->solve(loads, points, spin_rad_s); });
}

Result<double> StressSolver::strainEnergy(const std::vector<PointForce>& loads) const {
    return guarded<double>([&] { return impl_->strainEnergy(loads); });
}

Result<StressField> StressSolver::solveContact(const ContactField& contact) const {
    return guarded<StressField>([&] { return impl_->solveContact(contact); });
}

Result<StressField> StressSolver::stressOfUnknowns(const Eigen::VectorXd& unknowns,
                                                   const ContactField& contact) const {
    return guarded<StressField>([&] { return impl_->stressOfUnknowns(unknowns, contact); });
}

Result<StressField> StressSolver::solveTraction(
    const std::function<Vec3(const Vec3& x, const Vec3& unit_normal)>& traction,
    const std::vector<Vec3>& points) const {
    return guarded<StressField>([&] { return impl_->solveTraction(traction, points); });
}

StressField StressSolver::stressOf(const std::function<Vec3(const Vec3& x)>& displacement,
                                   const std::function<Mat3(const Vec3& x)>& gradient) const {
    return impl_->stressOf(displacement, gradient);
}

Result<std::shared_ptr<const ReducedStress>> StressSolver::reduced(const Progress& progress) const {
    return guarded<std::shared_ptr<const ReducedStress>>([&] { return impl_->reduced(progress); });
}

const StressSolverReport& StressSolver::report() const {
    return impl_->report;
}

StressSolver::StressSolver(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StressSolver::StressSolver(StressSolver&&) noexcept = default;
StressSolver& StressSolver::operator=(StressSolver&&) noexcept = default;
StressSolver::~StressSolver() = default;

}  // namespace sherd
