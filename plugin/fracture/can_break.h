#pragma once

#include "core/loads/blow.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// Whether a blow is worth a solve; it costs next to nothing to ask. False when the blow brings less energy
/// than it takes to pay for the smallest crack, or to bring one particle's share of the material to failure:
/// then no solve can end in a break.
bool canBreak(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture);

}  // namespace sherd
