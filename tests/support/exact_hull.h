#pragma once

#include <LinearMath/btConvexHullComputer.h>

#include <cmath>
#include <vector>

#include "bullet/world/conversions.h"
#include "geometry/convex/convex_hull.h"

namespace sherd {

/// The hull of points, by btConvexHullComputer: exact in integers, so no input upsets it.
inline ConvexHull exactHull(const std::vector<Vec3>& points) {
    ConvexHull hull;
    if (points.empty()) return hull;
    btConvexHullComputer computer;
    computer.compute(points.front().data(), sizeof(Vec3), static_cast<int>(points.size()), 0, 0);
    for (int v = 0; v < computer.vertices.size(); ++v)
        hull.vertices.push_back(fromBullet(computer.vertices[v]));
    double six_volumes = 0;
    for (int f = 0; f < computer.faces.size(); ++f) {
        const auto* const first = &computer.edges[computer.faces[f]];
        const Vec3& corner = hull.vertices[first->getSourceVertex()];
        for (auto* edge = first->getNextEdgeOfFace(); edge != first; edge = edge->getNextEdgeOfFace()) {
            const Vec3 &from = hull.vertices[edge->getSourceVertex()],
                       &to = hull.vertices[edge->getTargetVertex()];
            six_volumes += (from - corner).cross(to - corner).dot(corner - hull.vertices[0]);
        }
    }
    hull.volume = std::abs(six_volumes) / 6;
    return hull;
}

}  // namespace sherd
