#include "core/loads/cap_area.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numerics/plane_crossing.h"

namespace sherd {

namespace {

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Of the disc about the origin, between the directions of a and b; negative where b comes first.
double sector(const Vec2& a, const Vec2& b, double radius) {
    return 0.5 * radius * radius * std::atan2(cross(a, b), a.dot(b));
}

/// What the edge from a to b adds to the area that a polygon shares with the disc: that of the triangle of
/// the origin and the edge.
double shareOfEdge(const Vec2& a, const Vec2& b, double radius) {
    const Vec2 along = b - a;
    const double squared = along.squaredNorm(), half = a.dot(along), rest = a.squaredNorm() - radius * radius;
    const double root = half * half - squared * rest;
    if (!(squared > 0)) return 0;
    if (!(root > 0)) return sector(a, b, radius);
    const double in = (-half - std::sqrt(root)) / squared, out = (-half + std::sqrt(root)) / squared;
    if (out <= 0 || in >= 1) return sector(a, b, radius);
    const Vec2 first = in > 0 ? Vec2(a + in * along) : a, last = out < 1 ? Vec2(a + out * along) : b;
    return (in > 0 ? sector(a, first, radius) : 0) + cross(first, last) / 2 +
           (out < 1 ? sector(last, b, radius) : 0);
}

std::vector<Vec3> partBelow(const TriangleCorners& triangle, const HalfSpace& below) {
    const auto height = [&](const Vec3& x) { return x.dot(below.normal) - below.offset_m; };
    std::vector<Vec3> part;
    walkAcrossPlane(
        3, [&](int i) { return height(triangle[i]) > 0; },
        [&](int i, bool above) {
            if (!above) part.push_back(triangle[i]);
        },
        [&](int i, int next, bool) {
            part.push_back(
                planeCrossing(triangle[i], height(triangle[i]), triangle[next], height(triangle[next])));
        });
    return part;
}

}  // namespace

double capArea(const TriangleCorners& triangle, const Vec3& centre, double radius, const HalfSpace& below) {
    const Vec3 area = areaVector(triangle);
    if (!(area.norm() > 0)) return 0;
    const Vec3 normal = area.normalized(), u = normal.unitOrthogonal(), v = normal.cross(u);
    const double height = normal.dot(triangle[0] - centre), squared = radius * radius - height * height;
    if (!(squared > 0)) return 0;
    std::vector<Vec2> polygon;
    for (const Vec3& x : partBelow(triangle, below))
        polygon.emplace_back(u.dot(x - centre), v.dot(x - centre));
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += shareOfEdge(polygon[i], polygon[(i + 1) % polygon.size()], std::sqrt(squared));
    return std::max(0.0, sum);
}

}  // namespace sherd
