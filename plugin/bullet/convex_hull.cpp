#include "bullet/convex_hull.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>

#include "bullet/conversions.h"

namespace sherd {

namespace {

/// Visits the corners of each face of a hull in order.
template <class Visit>
void forEachFace(const btConvexHullComputer& hull, const Visit& visit) {
    std::vector<Vec3> corners;
    for (int f = 0; f < hull.faces.size(); ++f) {
        corners.clear();
        const btConvexHullComputer::Edge* const first = &hull.edges[hull.faces[f]];
        const auto* edge = first;
        do {
            corners.push_back(fromBullet(hull.vertices[edge->getSourceVertex()]));
            edge = edge->getNextEdgeOfFace();
        } while (edge != first);
        visit(corners);
    }
}

Vec3 areaVectorOf(const std::vector<Vec3>& corners) {
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 2; i < corners.size(); ++i)
        area += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    return area / 2;
}

double enclosedVolume(const btConvexHullComputer& hull) {
    if (hull.vertices.size() == 0) return 0;
    const Vec3 origin = fromBullet(hull.vertices[0]);
    double three_volumes = 0;
    forEachFace(hull, [&](const std::vector<Vec3>& corners) {
        three_volumes += areaVectorOf(corners).dot(corners[0] - origin);
    });
    return std::abs(three_volumes) / 3;
}

void compute(btConvexHullComputer& computer, const std::vector<Vec3>& points) {
    computer.compute(points.front().data(), sizeof(Vec3), static_cast<int>(points.size()), 0, 0);
}

ConvexHull result(const btConvexHullComputer& computer) {
    ConvexHull hull;
    for (int v = 0; v < computer.vertices.size(); ++v)
        hull.vertices.push_back(fromBullet(computer.vertices[v]));
    hull.volume = enclosedVolume(computer);
    return hull;
}

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

ConvexHull convexHull(const std::vector<Vec3>& points) {
    if (points.empty()) return {};
    btConvexHullComputer computer;
    compute(computer, points);
    return result(computer);
}

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
