#include "fracture/crack_energy.h"

#include <algorithm>
#include <limits>

namespace sherd {

double smallestCrackEnergy(const BreakableSolid& solid, const FractureSettings& fracture) {
    const double section = solid.wallThickness() * solid.wallThickness();
    return section * solid.material().fracture_energy_j_m2 / fracture.energy_into_cracks;
}

double affordableCrackArea(const BreakableSolid& solid, const FractureSettings& fracture,
                           double strain_energy_j) {
    constexpr double over_estimate = 4;
    if (fracture.fragment_count > 0) return std::numeric_limits<double>::infinity();
    const double share = std::min(1.0, over_estimate * fracture.energy_into_cracks);
    return share * strain_energy_j / solid.material().fracture_energy_j_m2;
}

}  // namespace sherd
