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
