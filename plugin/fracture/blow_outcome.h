#pragma once

#include <sherd/outcome.h>

#include <vector>

#include "fracture/fragments.h"

namespace sherd {

/// What came of a blow.
struct BlowOutcome : BlowFigures {
    std::vector<Fragment> fragments;  ///< empty unless it broke
    int damaged_particles = 0;
};

}  // namespace sherd
