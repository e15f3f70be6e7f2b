#include "fracture/crack_energy.h"

namespace sherd {

double smallestCrackEnergy(const BreakableSolid& solid, const FractureSettings& fracture) {
    const double section = solid.wallThickness() * solid.wallThickness();
    return section * solid.material().fracture_energy_j_m2 / fracture.energy_into_cracks;
}

}  // namespace sherd
