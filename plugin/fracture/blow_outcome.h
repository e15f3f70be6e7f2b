#pragma once

#include <sherd/outcome.h>

#include <memory>
#include <vector>

#include "core/damage/damaged_material.h"
#include "fracture/fragments.h"

namespace sherd {

/// What came of a blow.
struct BlowOutcome : BlowFigures {
    std::vector<Fragment> fragments;  ///< empty unless it broke
    int damaged_particles = 0;
    /// If the blow damaged the body and yet no piece came loose: all that is damaged of it now.
    std::shared_ptr<const DamagedMaterial> damaged;
};

}  // namespace sherd
