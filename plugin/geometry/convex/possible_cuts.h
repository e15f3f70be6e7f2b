#pragma once

#include <vector>

#include "geometry/convex/surface_cloud.h"

namespace sherd {

/// What is to be small in the two parts that a cut leaves, added up: the volumes of their hulls, and a little
/// their lengths. The hulls of a ring's parts add up to the same wherever it is cut at first; a cut through
/// the middle is the one that leads on.
double priceOf(double hull_volume, double length);

/// The plane across each axis that leaves the cheapest two parts, by an estimate: through a flat face of the
/// surface where there is one near. No plane for an axis along which there is nothing to cut.
/// The cheapest comes first.
std::vector<AxisPlane> possibleCuts(const SurfaceCloud& cloud);

}  // namespace sherd
