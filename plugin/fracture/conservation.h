#pragma once

#include <vector>

#include "fracture/fragments.h"

namespace sherd {

/// What all fragments together have too much or too little of, relative to the whole.
struct ConservationErrors {
    double mass_rel = 0, volume_rel = 0;
};
ConservationErrors conservationErrors(const BreakableSolid& solid, const std::vector<Fragment>& fragments);

}  // namespace sherd
