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

/// The hull of the outermost points in `directions` directions spread evenly over the sphere: no more
/// vertices than that, in a small part of the time, and a little smaller.
ConvexHull roughHull(const std::vector<Vec3>& points, int directions);

}  // namespace sherd
