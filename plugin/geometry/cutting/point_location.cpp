#include "geometry/cutting/point_location.h"

#include "geometry/cutting/exact_orientation.h"

namespace sherd {

FirstHit firstHit(const Vec3& from, const Vec3& to, const std::vector<Vec3>& points,
                  const std::vector<Triangle>& triangles) {
    FirstHit hit;
    double nearest = 2;
    const Vec3 low = from.cwiseMin(to), high = from.cwiseMax(to);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const Vec3 &a = points[triangles[k][0]], &b = points[triangles[k][1]], &c = points[triangles[k][2]];
        if ((a.cwiseMin(b).cwiseMin(c).array() > high.array()).any() ||
            (a.cwiseMax(b).cwiseMax(c).array() < low.array()).any())
            continue;
        const int start = orientation(a, b, c, from), end = orientation(a, b, c, to);
        if (start == end && start != 0) continue;
        const int ab = orientation(from, to, a, b), bc = orientation(from, to, b, c),
                  ca = orientation(from, to, c, a);
        if ((ab > 0 || bc > 0 || ca > 0) && (ab < 0 || bc < 0 || ca < 0)) continue;
        if (ab * bc * ca * start * end == 0) {
            hit.degenerate = true;
            return hit;
        }
        const double at_start = signedVolume(a, b, c, from),
                     t = at_start / (at_start - signedVolume(a, b, c, to));
        if (t >= nearest) continue;
        nearest = t;
        hit.triangle = static_cast<int>(k);
        hit.above = start > 0;
    }
    return hit;
}

bool isInside(const Vec3& x, const std::vector<Vec3>& points, const std::vector<Triangle>& surface) {
    // The way to a point a little beyond the middle of a triangle meets the surface there, or before. If it
    // is degenerate another triangle is tried.
    for (std::size_t k = 0; k < surface.size(); ++k) {
        const auto& [a, b, c] = surface[k];
        const Vec3 middle = 0.37 * points[a] + 0.34 * points[b] + 0.29 * points[c];
        const FirstHit hit = firstHit(x, x + 1.01 * (middle - x), points, surface);
        if (!hit.degenerate && hit.triangle >= 0) return !hit.above;
    }
    return false;
}

}  // namespace sherd
