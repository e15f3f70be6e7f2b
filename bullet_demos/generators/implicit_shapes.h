#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace sherd::generators {

// Solids as signed distances, m: negative inside, positive outside. Two solids are joined or cut with a round
// edge of given radius, as if a ball had rolled along it, so that every surface is smooth.

/// Everything within `reach` of a rectangle with half extents `half`, centred at the origin.
inline double roundedRectangle(const Eigen::Vector2d& point, const Eigen::Vector2d& half, double reach) {
    const Eigen::Vector2d beyond = point.cwiseAbs() - half;
    return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - reach;
}

/// Two circles and what lies between their common tangents: one of radius `first` about the origin, one of
/// radius `last` at `length` along the axis. `along` and `off` are the point's distances along the axis and
/// from it. In the plane this is a rounded, tapered strip, turned about its axis a round cone.
inline double taperedCapsule(double along, double off, double first, double last, double length) {
    const double slope = (first - last) / length, flank = std::sqrt(1 - slope * slope);
    const double foot = flank * along - slope * off;
    if (foot < 0) return std::hypot(along, off) - first;
    if (foot > flank * length) return std::hypot(along - length, off) - last;
    return slope * along + flank * off - first;
}

/// What is in both, with a convex edge of radius `round`.
inline double intersectRound(double a, double b, double round) {
    const Eigen::Vector2d inside(std::max(round + a, 0.0), std::max(round + b, 0.0));
    return std::min(-round, std::max(a, b)) + inside.norm();
}

/// What is in either, with a fillet of radius `round` where they meet.
inline double uniteRound(double a, double b, double round) {
    return -intersectRound(-a, -b, round);
}

}  // namespace sherd::generators
