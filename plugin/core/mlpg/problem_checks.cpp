#include "core/mlpg/problem_checks.h"

#include <cmath>

namespace sherd {
namespace {

constexpr double largest_poisson_ratio = 0.499;

Status checkCombination(const StressSettings& settings) {
    const bool heaviside = settings.test_function != TestFunction::galerkin;
    const std::string name =
        settings.test_function == TestFunction::heaviside_paper ? "heaviside_paper" : "heaviside";
    if (heaviside && settings.trial_function == TrialFunction::spline)
        return Error{"Spline trial functions go with galerkin test functions; use " + name + " with mls."};
    constexpr int largest_particle_degree = 2;
    if (settings.trial_function != TrialFunction::spline &&
        splineDegree(settings.basis) > largest_particle_degree)
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

}  // namespace

Status checkStressProblem(const Discretisation* solid, const Material& material,
                          const StressSettings& settings) {
    if (!solid || solid->particles.empty() || solid->cells.empty())
        return Error{"The stress solver was given a solid without particles; sample it first."};
    if (!(material.youngs_modulus_pa > 0) || !std::isfinite(material.youngs_modulus_pa))
        return Error{"Young's modulus must be positive and finite."};
    if (!(material.poisson_ratio > -1 && material.poisson_ratio <= largest_poisson_ratio))
        return Error{
            "Poisson's ratio must be above -1 and at most 0.499, since displacements alone cannot tell the "
            "pressure in a body that keeps its volume; for rubber-like material use 0.49."};
    if (const Status valid = settings.validate(); !valid) return valid;
    return checkCombination(settings);
}

}  // namespace sherd
