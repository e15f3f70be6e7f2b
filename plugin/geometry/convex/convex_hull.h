#pragma once

#include <sherd/types.h>

#include <vector>

#include "geometry/convex/growing_hull.h"

namespace sherd {

/// A convex polyhedron.
struct ConvexHull {
    std::vector<Vec3> vertices;  ///< m
    double volume = 0;           ///< m^3; 0 for points in a plane, or nearly so
    double outside = 0;  ///< how far some of the points that it is the hull of may lie outside it, about, m
};

/// The hull of a few of the points: of those outermost in 26 directions, and then always the one furthest
/// outside, until there are `most_vertices` (or these 26 are more) or none lies further out than
/// `tolerance_m`.
ConvexHull simpleHull(const std::vector<Vec3>& points, int most_vertices, double tolerance_m);

/// The same, from the rough hull of the points on.
ConvexHull simpleHull(const std::vector<Vec3>& points, GrowingHull rough, int most_vertices,
                      double tolerance_m);

}  // namespace sherd
