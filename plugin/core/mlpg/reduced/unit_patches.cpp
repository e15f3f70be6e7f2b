#include "core/mlpg/reduced/unit_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// Numbers of points, each farthest from those before it; the first is farthest from the centroid.
std::vector<int> spreadOut(const std::vector<Vec3>& points, int count) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& point : points) centre += point / static_cast<double>(points.size());
    std::vector<double> squared(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) squared[i] = (points[i] - centre).squaredNorm();
    std::vector<int> chosen;
    while (static_cast<int>(chosen.size()) < count) {
        const auto farthest = std::max_element(squared.begin(), squared.end());
        if (!(*farthest > 0)) break;
        const int next = static_cast<int>(farthest - squared.begin());
        if (chosen.empty()) squared.assign(points.size(), std::numeric_limits<double>::infinity());
        chosen.push_back(next);
        for (std::size_t i = 0; i < points.size(); ++i)
            squared[i] = std::min(squared[i], (points[i] - points[next]).squaredNorm());
    }
    return chosen;
}

}  // namespace

std::vector<UnitPatch> unitPatches(const Discretisation& solid, int count) {
    std::vector<Vec3> positions, normals;
    std::vector<double> areas;
    double area = 0;
    for (const SurfacePoint& point : solid.surface_points) {
        const double own = point.area.norm();
        if (!(own > 0)) continue;
        positions.push_back(point.position);
        normals.push_back(point.area / own);
        areas.push_back(own);
        area += own;
    }
    const double radius = std::sqrt(area / (pi * count));
    std::vector<UnitPatch> patches;
    for (const int middle : spreadOut(positions, count)) {
        UnitPatch patch;
        patch.middle = positions[middle];
        double sum = 0;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            if ((positions[i] - patch.middle).squaredNorm() > radius * radius) continue;
            if (!(normals[i].dot(normals[middle]) > 0)) continue;  // the other face of a wall
            patch.points.push_back({positions[i], areas[i]});
            sum += areas[i];
        }
        for (UnitPatch::Point& point : patch.points) point.weight /= sum;
        patches.push_back(std::move(patch));
    }
    return patches;
}

}  // namespace sherd
