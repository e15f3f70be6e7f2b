#pragma once

#include <sherd/types.h>

#include <optional>
#include <utility>
#include <vector>

#include "geometry/cutting/edge_table.h"

namespace sherd {

/// Triangles that close a plane cut: a constrained Delaunay triangulation in the plane, without new points.
/// `outlines`: directed edges that make up closed lines, holes among them, with the inside on their left seen
/// against the normal, about which the triangles turn. Without edges there is nothing to close. None if the
/// edges make up no such lines, or if rounding makes these touch or cross.
std::optional<std::vector<Triangle>> triangulateCap(const std::vector<Vec3>& points, const Vec3& normal,
                                                    const std::vector<std::pair<int, int>>& outlines);

}  // namespace sherd
