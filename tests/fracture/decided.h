#pragma once

#include <utility>

#include "fracture/decide_blow.h"

namespace sherd {

/// What comes of a blow, by all levels.
inline BlowOutcome decided(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture) {
    StageTimes before;
    if (auto held = heldByGate(solid, blow, fracture, 1, before.gate)) return std::move(*held);
    BlowOutcome out = solveBlow(solid, blow, fracture, 1);
    out.ms += before;
    return out;
}

}  // namespace sherd
