#pragma once

#include "fracture/pipeline.h"

namespace sherd {

/// With the fracture settings that the asset was made with.
inline BlowOutcome strike(const BreakableSolid& solid, const Blow& blow, std::uint64_t seed) {
    return strike(solid, blow, solid.settings().fracture, seed);
}
inline bool canBreak(const BreakableSolid& solid, const Blow& blow) {
    return canBreak(solid, blow, solid.settings().fracture);
}

}  // namespace sherd
