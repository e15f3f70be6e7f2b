#include "core/sampling/polygon_clipping.h"

#include <algorithm>

namespace sherd {
namespace {

/// Where the edge from `a` (below) to `b` (on or above) meets the plane.
Vec3 cutPoint(const Vec3& a, const Vec3& b, int axis, double plane) {
    if (b[axis] == plane) return b;
    // `a` lies below and `b` above for both triangles of an edge, so this order is already canonical.
    const double t = (plane - a[axis]) / (b[axis] - a[axis]);
    Vec3 p = a + t * (b - a);
    p = p.cwiseMax(a.cwiseMin(b)).cwiseMin(a.cwiseMax(b));
    p[axis] = plane;
    return p;
}

}  // namespace

void cutPolygon(const Polygon& polygon, int axis, double plane, Polygon& below, Polygon& above) {
    below.count = above.count = 0;
    for (int i = 0; i < polygon.count; ++i) {
        const Vec3& p = polygon.points[i];
        const Vec3& q = polygon.points[i + 1 == polygon.count ? 0 : i + 1];
        const bool p_above = p[axis] >= plane, q_above = q[axis] >= plane;
        (p_above ? above : below).add(p);
        if (p_above == q_above) continue;
        const Vec3 cut = p_above ? cutPoint(q, p, axis, plane) : cutPoint(p, q, axis, plane);
        below.add(cut);
        above.add(cut);
    }
    below.close();
    above.close();
}

}  // namespace sherd
