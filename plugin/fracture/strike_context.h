#pragma once

#include <cstdint>

#include "fracture/breakable_solid.h"

namespace sherd {

/// A solid under a blow: what the stages work with.
struct StrikeContext {
    const BreakableSolid& solid;
    const Discretisation& sampling;    ///< of the solid
    const FractureSettings& fracture;  ///< how it breaks
    std::uint64_t seed;                ///< of the pattern of cracks
};

}  // namespace sherd
