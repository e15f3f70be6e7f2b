#include "bullet/convex_hull.h"

#include <algorithm>

#include "core/numerics/mesh_measures.h"

namespace sherd {

namespace {

constexpr double even =
    0.02;  // of the hull's thickness, by which the corners of one side may leave its plane

/// Of points in a plane: those outermost in 26 directions, without a volume.
ConvexHull flatHull(const std::vector<Vec3>& points) {
    if (points.empty()) return {};
    std::vector<std::size_t> outermost;
    for (int d = 0; d < 27; ++d) {
        const Vec3 way(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1);
        const auto furthest =
            std::max_element(points.begin(), points.end(),
                             [&](const Vec3& a, const Vec3& b) { return way.dot(a) < way.dot(b); });
        outermost.push_back(static_cast<std::size_t>(furthest - points.begin()));
    }
    std::sort(outermost.begin(), outermost.end());
    outermost.erase(std::unique(outermost.begin(), outermost.end()), outermost.end());
    ConvexHull hull;
    for (const std::size_t place : outermost) hull.vertices.push_back(points[place]);
    return hull;
}

/// Whether none of the points lies further outside a side than `even_m`. Where many lie in a plane but for
/// rounding, some triangles of a hull face inwards.
bool supports(const FlatSide& side, const std::vector<Vec3>& points, double even_m) {
    if (side.corners.size() < 3) return false;
    const double height = side.normal.dot(points[side.corners.front()]);
    return std::all_of(points.begin(), points.end(),
                       [&](const Vec3& point) { return side.normal.dot(point) < height + 2 * even_m; });
}

/// The sides, with their corners counted among the hull's vertices. Corners inside an edge are none of them.
std::vector<FlatSide> sidesOf(const std::vector<Vec3>& points, const std::vector<Vec3>& hull_points,
                              const GrowingHull& grown, const std::vector<int>& vertices, double even_m) {
    std::vector<FlatSide> sides = flatSides(points, grown.triangles(), even_m);
    for (FlatSide& side : sides) {
        std::vector<int> corners;
        for (const int point : side.corners) {
            const auto found = std::lower_bound(vertices.begin(), vertices.end(), point);
            if (found != vertices.end() && *found == point)
                corners.push_back(static_cast<int>(found - vertices.begin()));
        }
        side.corners = std::move(corners);
    }
    sides.erase(std::remove_if(sides.begin(), sides.end(),
                               [&](const FlatSide& side) { return !supports(side, hull_points, even_m); }),
                sides.end());
    return sides;
}

}  // namespace

ConvexHull simpleHull(const std::vector<Vec3>& points, int most_vertices, double tolerance_m) {
    return simpleHull(points, GrowingHull(points), most_vertices, tolerance_m);
}

ConvexHull simpleHull(const std::vector<Vec3>& points, GrowingHull rough, int most_vertices,
                      double tolerance_m) {
    if (rough.isFlat()) return flatHull(points);
    rough.growTo(most_vertices, tolerance_m);
    ConvexHull hull;
    const std::vector<int> vertices = rough.vertices();
    for (const int place : vertices) hull.vertices.push_back(points[place]);
    hull.volume = rough.volume();
    hull.outside = rough.outside();
    const double thickness = boundingBox(hull.vertices).sizes().minCoeff();
    hull.sides = sidesOf(points, hull.vertices, rough, vertices, std::max(even * thickness, hull.outside));
    return hull;
}

}  // namespace sherd
