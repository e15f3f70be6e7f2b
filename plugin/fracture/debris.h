#pragma once

#include <vector>

#include "fracture/fragments.h"

namespace sherd {

/// Pieces below this volume are debris, m^3: what the settings say, or a share of the solid.
double smallestFragment(const BreakableSolid& solid, const FractureSettings& fracture);

/// For Debris::dropped: marks the pieces below a volume as dropped, but never the largest piece. (`merged` is
/// done with the labels of particles, `unbreakable` where contacts are collected.)
void markDropped(double smallest_m3, std::vector<Fragment>& fragments);

}  // namespace sherd
