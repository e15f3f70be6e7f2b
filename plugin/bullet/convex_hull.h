#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// A convex polyhedron.
struct ConvexHull {
    std::vector<Vec3> vertices;  ///< m
    double volume = 0;           ///< m^3; 0 for points in a plane
    double outside = 0;  ///< how far some of the points that it is the hull of may lie outside it, about, m
};

/// The hull of points (btConvexHullComputer: exact in integers, so no input upsets it).
ConvexHull convexHull(const std::vector<Vec3>& points);

/// The hull of a few of the points: of those outermost in 26 directions, and then of those furthest outside
/// the faces, until there are `most_vertices` or none lies further out than `tolerance_m`. The time grows
/// with the number of points, not with how many of them the whole hull would have.
ConvexHull simpleHull(const std::vector<Vec3>& points, int most_vertices, double tolerance_m);

/// The volume of the hull of the points that are outermost in 26 directions, m^3: a little less than that of
/// all. `box`: that of the points.
double roughHullVolume(const std::vector<Vec3>& points, const Eigen::AlignedBox3d& box);

}  // namespace sherd
