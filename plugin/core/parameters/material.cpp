#include <sherd/material.h>

#include "core/damage/failure_criterion.h"
#include "core/numerics/range_checks.h"

namespace sherd {

Status Material::validate() const {
    return RangeChecks("Material '" + name + "'")
        .require(isPositive(youngs_modulus_pa), "youngs_modulus_pa", youngs_modulus_pa, "positive, in Pa")
        .require(isWithin(poisson_ratio, 0, 0.499), "poisson_ratio", poisson_ratio,
                 "between 0 and 0.499 (0.5 is incompressible)")
        .require(isPositive(density_kg_m3), "density_kg_m3", density_kg_m3, "positive, in kg/m^3")
        .require(isPositive(tensile_strength_pa), "tensile_strength_pa", tensile_strength_pa,
                 "positive, in Pa")
        .require(isWithin(strength_scatter, 0, 1), "strength_scatter", strength_scatter,
                 "between 0 and 1 (standard deviation over mean)")
        .require(compressive_strength_pa >= tensile_strength_pa, "compressive_strength_pa",
                 compressive_strength_pa, "at least tensile_strength_pa (infinite: never crushed)")
        .require(weibull_modulus == 0 || isWithin(weibull_modulus, 1, 1000), "weibull_modulus",
                 weibull_modulus, "0 (none) or between 1 and 1000")
        .require(isPositive(weibull_volume_m3), "weibull_volume_m3", weibull_volume_m3, "positive, in m^3")
        .require(isPositive(fracture_energy_j_m2), "fracture_energy_j_m2", fracture_energy_j_m2,
                 "positive, in J/m^2")
        .require(failureCriterion(failure_criterion) != nullptr, "failure_criterion",
                 "'" + failure_criterion + "'", ("one of " + failureCriterionNames()).c_str())
        .status();
}

}  // namespace sherd
