#include "core/mlpg/particle_forms/stress_problem.h"

#include "core/mlpg/particle_forms/cell_strains.h"
#include "core/mlpg/particle_forms/particle_motions.h"

namespace sherd {
namespace {

constexpr double locking_poisson_ratio = 0.35;

double supportRadius(const StressSettings& settings) {
    if (settings.support_radius > 0) return settings.support_radius;
    if (settings.basis == Basis::quadratic) return 2.8;
    return settings.trial_function == TrialFunction::gmls ? 1.4 : 2.2;
}

}  // namespace

StressProblem::StressProblem(const Discretisation& sampled, const Material& material,
                             const StressSettings& settings)
    : solid(sampled),
      support_radius(supportRadius(settings)),
      elasticity(material),
      space{settings.trial_function, settings.basis},
      supports(sampled, support_radius),
      motions(particleMotions(sampled, space)),
      cells(smoothedGradients(sampled, supports, space)) {}

std::vector<std::string> trustWarnings(const StressProblem& problem, const Material& material) {
    std::vector<std::string> warnings;
    const auto warnAbout = [&](Evaluation state, const char* consequence) {
        const int count = problem.cells.evaluations[static_cast<size_t>(state)];
        if (count > 0)
            warnings.push_back("At " + std::to_string(count) + " integration points " + consequence);
    };
    warnAbout(Evaluation::widened,
              "the supports were widened to reach enough particles; if there are many, use a larger support "
              "radius.");
    warnAbout(
        Evaluation::reduced,
        "the quadratic basis was replaced by the linear one for lack of particles; use a finer spacing or "
        "the linear basis.");
    warnAbout(
        Evaluation::deficient,
        "the particles lie in one plane or line, so that bending there is lost; use gmls trial functions "
        "or a finer spacing.");
    if (material.poisson_ratio > locking_poisson_ratio)
        warnings.push_back(
            "At this Poisson's ratio walls with fewer than three layers of particles, or an even number of "
            "them, come out "
            "too stiff in bending; use three or five across a wall, or spline trial functions.");
    return warnings;
}

std::vector<Mat3> cellStresses(const StressProblem& problem, const Eigen::VectorXd& unknowns) {
    std::vector<Mat3> stresses = displacementGradients(problem.cells, unknowns);
    for (Mat3& stress : stresses) stress = problem.elasticity.stress(stress);
    return stresses;
}

}  // namespace sherd
