#pragma once

#include <vector>

#include "fracture/fragments.h"

namespace sherd {

/// Mass and volume of all fragments together less those of the whole solid, relative to the whole.
struct ConservationErrors {
    double mass_rel = 0, volume_rel = 0;
};
ConservationErrors conservationErrors(const BreakableSolid& solid, const std::vector<Fragment>& fragments);

}  // namespace sherd
