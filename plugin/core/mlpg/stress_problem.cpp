#include "core/mlpg/stress_problem.h"

#include <cmath>

namespace sherd {
namespace {

constexpr double largest_poisson_ratio = 0.499;
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
      motions(sampled, space),
      cells(smoothedGradients(sampled, supports, space)) {}

Status checkStressProblem(const Discretisation* solid, const Material& material,
                          const StressSettings& settings) {
    if (!solid || solid->particles.empty() || solid->cells.empty())
        return Error{"The stress solver was given a solid without particles; sample it first."};
    if (!(material.youngs_modulus_pa > 0) || !std::isfinite(material.youngs_modulus_pa))
        return Error{"Young's modulus must be positive and finite."};
    if (!(material.poisson_ratio > -1 && material.poisson_ratio <= largest_poisson_ratio))
        return Error{
            "Poisson's ratio must be above -1 and at most 0.499, since displacements alone cannot tell the "
            "pressure in a "
            "body that keeps its volume; for rubber-like material use 0.49."};
    if (!(settings.support_radius >= 0 && settings.support_radius < 10))
        return Error{"The support radius is in particle spacings: 0 for the default, or about 1.3 to 3.5."};
    const bool heaviside = settings.test_function != TestFunction::galerkin;
    const std::string name =
        settings.test_function == TestFunction::heaviside_paper ? "heaviside_paper" : "heaviside";
    if (heaviside && settings.trial_function == TrialFunction::spline)
        return Error{"Spline trial functions go with galerkin test functions; use " + name + " with mls."};
    if (settings.trial_function != TrialFunction::spline && settings.basis == Basis::cubic)
        return Error{
            "The cubic basis is there for spline trial functions; use linear or quadratic with mls and "
            "gmls."};
    if (heaviside && settings.trial_function == TrialFunction::gmls)
        return Error{
            "Heaviside test functions give 3 equations a particle and gmls trial functions have 12 unknowns: "
            "use " +
            name + " with mls, or gmls with galerkin test functions."};
    return success();
}

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
