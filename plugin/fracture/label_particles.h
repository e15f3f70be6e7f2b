#pragma once

#include "core/clustering/fragment_labels.h"
#include "core/damage/damage.h"
#include "fracture/blow_stress.h"
#include "fracture/strike_context.h"

namespace sherd {

/// The fragment of every particle: undamaged parts and clusters of damaged ones, merged until they are as few
/// and as large as the settings say.
FragmentLabels labelParticles(const StrikeContext& struck, const Damage& damage, const BlowForces& forces);

}  // namespace sherd
