#include "geometry/convex/convex_hull.h"

#include <algorithm>

namespace sherd {

namespace {

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

}  // namespace

ConvexHull simpleHull(const std::vector<Vec3>& points, int most_vertices, double tolerance_m) {
    return simpleHull(points, GrowingHull(points), most_vertices, tolerance_m);
}

ConvexHull simpleHull(const std::vector<Vec3>& points, GrowingHull rough, int most_vertices,
                      double tolerance_m) {
    if (rough.isFlat()) return flatHull(points);
    rough.growTo(most_vertices, tolerance_m);
    ConvexHull hull;
    for (const int place : rough.vertices()) hull.vertices.push_back(points[place]);
    hull.volume = rough.volume();
    hull.outside = rough.outside();
    return hull;
}

}  // namespace sherd
