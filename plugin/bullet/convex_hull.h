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

/// A hull of at most `most` of the same vertices, those that lie furthest out of the hull of the others
/// first.
ConvexHull thinnedHull(const ConvexHull& hull, int most);

}  // namespace sherd
