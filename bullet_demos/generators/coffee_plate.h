#pragma once

#include "generators/implicit_mesher.h"

namespace sherd::generators {

/// Measures of a plate that stands with its foot ring on z = 0, around the z axis. All in m.
struct PlateMeasures {
    double rim_radius = 0.0875;  ///< of the rim's centre line
    double flat_radius = 0.040;  ///< of the flat middle
    double rise = 0.016;         ///< of the rim's centre line over that of the middle
    double thickness = 0.005;
    double foot_radius = 0.034;  ///< of the ring's centre line
    double foot_width = 0.0054;
    double foot_height = 0.0035;  ///< of the free space below the middle
    double foot_fillet = 0.003;   ///< where the ring meets the plate
};

/// Flat in the middle, with a border that rises along an arc, and a foot ring below.
ImplicitSolid coffeePlate(const PlateMeasures& plate);

}  // namespace sherd::generators
