#include "core/mlpg/stress_solver_impl.h"

// In place of the folder particle_forms where the option SHERD_PARTICLE_FORMS leaves it out.
namespace sherd {

Result<std::unique_ptr<StressSolver::Impl>> StressSolver::Impl::overParticles(
    std::shared_ptr<const Discretisation>, const Material&, const StressSettings& settings) {
    const std::string asked = settings.trial_function == TrialFunction::gmls ? "gmls" : "mls";
    return Error{"The trial functions '" + asked +
                 "' were asked for, but this library was built without the forms on particles; use 'spline', "
                 "or build Sherd with the CMake option SHERD_PARTICLE_FORMS=ON."};
}

}  // namespace sherd
