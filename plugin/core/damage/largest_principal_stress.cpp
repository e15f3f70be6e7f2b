#include <algorithm>

#include "core/damage/failure_criterion.h"
#include "core/stress/elasticity.h"

namespace sherd {

namespace {

double compressiveOverTensile(const Material& material) {
    return material.compressive_strength_pa / material.tensile_strength_pa;
}

double equivalentStress(const PrincipalStresses& stress, const Material& material) {
    return std::max(stress.largest, -stress.smallest / compressiveOverTensile(material));
}

// What fails has one principal stress at the tensile strength or one at minus the compressive strength, so it
// lies on one of six planes of the principal stresses or beyond. All planes of a kind hold the same least
// energy (they differ in the order of the axes alone), and the least of all lies on one of the nearest kind.
// For tension that is s^2 / (2 (lambda + 2 mu)) = s^2 (1 - 2 nu^2 / (1 - nu)) / (2 E), at the other two
// principal stresses nu / (1 - nu) s.
double leastEnergyDensity(double tensile_strength_pa, const Material& material) {
    const double crushing_pa = tensile_strength_pa * compressiveOverTensile(material);
    return Elasticity(material).leastEnergyDensity(Vec3::UnitX(), std::min(tensile_strength_pa, crushing_pa));
}

}  // namespace

/// Rankine's: failure where the largest principal stress reaches the tensile strength, or where the largest
/// compression reaches the compressive strength.
extern const FailureCriterion largest_principal_stress = {"largest_principal_stress", equivalentStress,
                                                          leastEnergyDensity};

}  // namespace sherd
