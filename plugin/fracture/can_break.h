#pragma once

#include "core/loads/blow.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// Whether a blow is worth a solve; it costs next to nothing to ask. False when the blow brings less energy
/// than it takes to pay for the smallest crack, or to bring one particle's share of the material to failure:
/// then no solve can end in a break. A prepared solid that stands free also knows bounds of its stress and
/// its strain energy
/// (`quickBound`, `closeBound`): false when they are below its weakest strength, or the smallest crack.
bool canBreak(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture);

/// Energy that a blow brings at least if it is worth a solve, J.
double leastEnergy(const BreakableSolid& solid, const FractureSettings& fracture);

}  // namespace sherd
