#include "fracture/can_break.h"

#include <algorithm>
#include <cmath>

#include "core/damage/particle_strengths.h"
#include "fracture/blow_stress.h"
#include "fracture/crack_energy.h"

namespace sherd {

namespace {

/// Least elastic energy of a particle that fails, J. The strength field is not asked, since its value at a
/// particle cannot be known before the solid is sampled.
double smallestFailureEnergy(const BreakableSolid& solid) {
    const Material& material = solid.material();
    const double volume = std::min(std::pow(solid.spacing(), 3), solid.moments().volume);
    const StrengthSettings& settings = solid.settings().strength;
    const double weakest_place = settings.field ? settings.field_minimum : 1;
    const double strength =
        material.tensile_strength_pa * weakestStrengthFraction(material, volume) * weakest_place;
    return solid.failureCriterion().least_energy_density_j_m3(strength, material) *
           solid.settings().sampling.smallest_fill * volume;
}

}  // namespace

// The solid stores no more energy than the blow brings. The first bound costs nothing; the second one reads
// the surface, and is closer.
bool canBreak(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture) {
    const double needed = std::max(smallestCrackEnergy(solid, fracture), smallestFailureEnergy(solid));
    return blowEnergy(blow, solid.mass(), isHeld(solid, blow)) > needed &&
           broughtEnergy(solid, blow, fracture.contact) > needed;
}

}  // namespace sherd
