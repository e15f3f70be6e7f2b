#pragma once

#include "fracture/breakable_solid.h"

namespace sherd {

/// Strain energy that a crack through a square of the wall's thickness takes, J (Griffith: its faces cost G_c
/// for each unit of area, paid from the part of the strain energy that goes into cracks).
double smallestCrackEnergy(const BreakableSolid& solid, const FractureSettings& fracture);

/// Of cracks that the energy of the blow pays for, m^2. How many pieces there are to be is an estimate by
/// what is damaged; cracks run on through what is not, and may cost a few times as much.
double affordableCrackArea(const BreakableSolid& solid, const FractureSettings& fracture,
                           double strain_energy_j);

}  // namespace sherd
