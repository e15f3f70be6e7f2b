#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// A convex polyhedron.
struct ConvexHull {
    std::vector<Vec3> vertices;  ///< m
    double volume = 0;           ///< m^3; 0 for points in a plane
};

/// The hull of points (btConvexHullComputer: exact in integers, so no input upsets it).
ConvexHull convexHull(const std::vector<Vec3>& points);

/// The hull of the outermost points in `directions` directions spread evenly over the sphere. It has no more
/// vertices than that, is a little smaller than the hull of all points, and takes far less time.
ConvexHull roughHull(const std::vector<Vec3>& points, int directions);

}  // namespace sherd
