#pragma once

#include "core/damage/damage.h"
#include "fracture/strike_context.h"

namespace sherd {

/// Number of clusters that the damaged part is split into: the settings' own, or what the strain energy pays
/// for, within the limits on count and size.
int clusterCount(const StrikeContext& struck, const Damage& damage, double strain_energy_j);

}  // namespace sherd
