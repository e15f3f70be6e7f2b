#pragma once

#include <sherd/types.h>

#include <array>
#include <vector>

namespace sherd {

/// Of a convex hull.
struct HullTriangle {
    std::array<int, 3> corners{};     ///< points, anticlockwise as seen from outside
    std::array<int, 3> neighbours{};  ///< triangles; neighbour i is beyond corners i and i + 1
    Vec3 normal = Vec3::Zero();       ///< outward, unit; zero of a triangle without an area
};

/// A flat polygon of a convex hull.
struct FlatSide {
    std::vector<int> corners;    ///< points, anticlockwise as seen from outside
    Vec3 normal = Vec3::Zero();  ///< outward, unit
};

/// The hull's sides: triangles next to each other that lie in one plane, up to `even_m`, are one side, whose
/// plane is that of the largest of them. Where these are no simple polygon, it is that triangle alone.
/// Largest triangles come first. The work is that of sorting the triangles.
std::vector<FlatSide> flatSides(const std::vector<Vec3>& points, const std::vector<HullTriangle>& triangles,
                                double even_m);

}  // namespace sherd
