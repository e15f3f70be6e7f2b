#include "core/damage/failure_criterion.h"
#include "core/stress/elasticity.h"

namespace sherd {

namespace {

/// 0 where the material is never crushed.
double tensileOverCompressive(const Material& material) {
    return material.tensile_strength_pa / material.compressive_strength_pa;
}

double equivalentStress(const PrincipalStresses& stress, const Material& material) {
    return stress.largest - tensileOverCompressive(material) * stress.smallest;
}

// With k = f_t / f_c >= 0, sigma_1 - k sigma_3 is the largest of sigma_i - k sigma_j over all i != j. So what
// fails lies on one of the six planes sigma_i - k sigma_j = s of the principal stresses, or beyond, whatever
// their order. All six hold the same least energy (they differ in the order of the axes alone), and that is
// the bound: s^2 / (2 (lambda (1 - k)^2 + 2 mu (1 + k^2))). It is attained, since the stress where one plane
// has it fails; without crushing (k = 0) it is that of the largest principal stress.
double leastEnergyDensity(double tensile_strength_pa, const Material& material) {
    return Elasticity(material).leastEnergyDensity({1, 0, -tensileOverCompressive(material)},
                                                   tensile_strength_pa);
}

}  // namespace

/// Mohr-Coulomb: failure where sigma_1 / f_t - sigma_3 / f_c reaches 1, with the largest and the smallest
/// principal stress and the uniaxial strengths in tension and compression (Labuz & Zang, Rock Mech. Rock Eng.
/// 45 (2012) 975). Shear with compression fails before either strength is reached; tension from all sides
/// bears more than f_t. If the compressive strength is infinite it is Rankine's criterion.
extern const FailureCriterion mohr_coulomb = {"mohr_coulomb", equivalentStress, leastEnergyDensity};

}  // namespace sherd
