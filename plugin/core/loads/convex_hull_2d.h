#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// Corners of the convex hull of points in the plane, counter-clockwise; one or two for points in a line.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

/// Distance of a point from a convex polygon, a segment or a point; 0 inside.
double distanceFromHull(const std::vector<Vec2>& hull, const Vec2& point);

/// Area of a convex polygon, m^2.
double hullArea(const std::vector<Vec2>& hull);

}  // namespace sherd
