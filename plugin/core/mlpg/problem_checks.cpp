#include "core/mlpg/problem_checks.h"

#include <cmath>

namespace sherd {
namespace {

constexpr double largest_poisson_ratio = 0.499;

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
    return settings.validate();
}

}  // namespace sherd
