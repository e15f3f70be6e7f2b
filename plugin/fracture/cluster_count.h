#pragma once

#include "core/damage/damage.h"
#include "fracture/strike_context.h"

namespace sherd {

/// Number of clusters that the damaged part is split into: the settings' own, as they are, or
/// what the strain energy pays for, within the limits on count and size. The volume counts every particle
/// that failed; specks that are given back to their surroundings later did take energy.
int clusterCount(const StrikeContext& struck, const Damage& damage, double strain_energy_j);

}  // namespace sherd
