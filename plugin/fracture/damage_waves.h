#pragma once

#include <sherd/outcome.h>
#include <sherd/result.h>

#include <vector>

#include "core/damage/damage.h"
#include "fracture/strike_context.h"

namespace sherd {

/// Goes on after the damage of the first solve: the stress without the damaged particles, under the same
/// force, damages more of them, until no more are damaged or the settings' number of waves is reached (paper,
/// section 6.1). Adds the times to `ms`.
Result<Damage> furtherWaves(const StrikeContext& struck, const std::vector<PointForce>& unit_loads,
                            double peak_force_n, Damage damage, StageTimes& ms);

}  // namespace sherd
