#include "fracture/conservation.h"

#include <cmath>

namespace sherd {

ConservationErrors conservationErrors(const BreakableSolid& solid, const std::vector<Fragment>& fragments) {
    double volume = 0, mass = 0;
    for (const Fragment& fragment : fragments) {
        volume += fragment.solid->moments().volume;
        mass += fragment.solid->mass();
    }
    return {std::abs(mass / solid.mass() - 1), std::abs(volume / solid.moments().volume - 1)};
}

}  // namespace sherd
