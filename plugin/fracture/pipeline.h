#pragma once

#include <cstdint>

#include "core/loads/blow.h"
#include "fracture/blow_outcome.h"
#include "fracture/breakable_solid.h"
#include "fracture/can_break.h"

namespace sherd {

/// The whole way from a blow to fragments (paper, Figure 1), for a blow that `canBreak` lets through. Never
/// throws: on any failure the outcome is `failed` and says why, and the body stays whole. `seed` stands in
/// for that of the settings. What blows damaged `earlier` is damaged still.
BlowOutcome strike(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                   std::uint64_t seed, const std::shared_ptr<const DamagedMaterial>& earlier = {});

}  // namespace sherd
