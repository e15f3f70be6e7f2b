#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// A convex polyhedron.
struct ConvexHull {
    std::vector<Vec3> vertices;  ///< m
    double volume = 0;           ///< m^3; 0 for points in a plane
};

/// The hull of points (btConvexHullComputer, which computes with exact integers and so never fails).
ConvexHull convexHull(const std::vector<Vec3>& points);

/// The hull of the outermost points in `directions` directions spread evenly over the sphere: at most so many
/// vertices, much faster, and slightly smaller than the exact hull.
ConvexHull roughHull(const std::vector<Vec3>& points, int directions);

}  // namespace sherd
