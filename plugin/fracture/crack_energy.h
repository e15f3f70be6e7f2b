#pragma once

#include "fracture/breakable_solid.h"

namespace sherd {

/// Strain energy below which no crack runs through even the thinnest section, J (Griffith: its faces cost G_c
/// for each unit of area, paid from the part of the strain energy that goes into cracks).
double smallestCrackEnergy(const BreakableSolid& solid, const FractureSettings& fracture);

}  // namespace sherd
