#include "core/sampling/polygon_clipping.h"

#include "core/numerics/plane_crossing.h"

namespace sherd {
namespace {

/// Where the edge from `a` (below) to `b` (on or above) meets the plane. The two triangles of an edge name
/// its ends in this same order, so both get the same bits; the point stays within the box of the edge.
Vec3 cutPoint(const Vec3& a, const Vec3& b, int axis, double plane) {
    if (b[axis] == plane) return b;
    const double t = (plane - a[axis]) / (b[axis] - a[axis]);
    Vec3 p = a + t * (b - a);
    p = p.cwiseMax(a.cwiseMin(b)).cwiseMin(a.cwiseMax(b));
    p[axis] = plane;
    return p;
}

}  // namespace

void cutPolygon(const Polygon& polygon, int axis, double plane, Polygon& below, Polygon& above) {
    below.count = above.count = 0;
    const auto& x = polygon.points;
    walkAcrossPlane(
        polygon.count, [&](int i) { return x[i][axis] >= plane; },
        [&](int i, bool is_above) { (is_above ? above : below).add(x[i]); },
        [&](int i, int next, bool is_above) {
            const Vec3 cut =
                is_above ? cutPoint(x[next], x[i], axis, plane) : cutPoint(x[i], x[next], axis, plane);
            below.add(cut);
            above.add(cut);
        });
    below.close();
    above.close();
}

}  // namespace sherd
