#include "core/loads/convex_hull_2d.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sherd {

namespace {

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
    // Andrew's monotone chain: the lower side from left to right, then the upper one back.
    const auto left = [](const Vec2& a, const Vec2& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    };
    std::sort(points.begin(), points.end(), left);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Vec2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (const Vec2& p : points) {
            while (hull.size() >= start + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the other side starts with it
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

double distanceFromHull(const std::vector<Vec2>& hull, const Vec2& point) {
    double nearest = std::numeric_limits<double>::infinity();  // squared
    bool inside = hull.size() > 2;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 &a = hull[i], edge = hull[i + 1 < hull.size() ? i + 1 : 0] - a, to = point - a;
        if (cross(edge, to) < 0) inside = false;
        const double length = edge.squaredNorm();
        const double along = length > 0 ? std::clamp(to.dot(edge) / length, 0.0, 1.0) : 0;
        nearest = std::min(nearest, (to - along * edge).squaredNorm());
    }
    return inside ? 0 : std::sqrt(nearest);
}

double hullArea(const std::vector<Vec2>& hull) {
    double area = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) area += 0.5 * cross(hull[i], hull[(i + 1) % hull.size()]);
    return area;
}

}  // namespace sherd
