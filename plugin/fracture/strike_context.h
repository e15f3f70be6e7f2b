#pragma once

#include <cstdint>
#include <memory>

#include "core/damage/damaged_material.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// A solid under a blow: what the stages work with.
struct StrikeContext {
    const BreakableSolid& solid;
    const Discretisation& sampling;    ///< of the solid
    const FractureSettings& fracture;  ///< how it breaks
    std::uint64_t seed;                ///< of the pattern of cracks
    /// What earlier blows damaged, without parting the body; nullptr: nothing.
    std::shared_ptr<const DamagedMaterial> earlier = nullptr;
};

}  // namespace sherd
