#pragma once

#include <sherd/types.h>

#include <array>
#include <vector>

namespace sherd {

/// Splits a polygon of three corners or more, given in their order around it, into triangles that turn as it
/// does; their corners are places in `corners`. Convex ones become a fan about the first corner, and so do
/// those that fold over themselves. The corners need not lie in one plane exactly.
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3>& corners);

}  // namespace sherd
