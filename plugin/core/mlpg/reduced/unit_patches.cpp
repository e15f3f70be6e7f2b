#include "core/mlpg/reduced/unit_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numerics/mesh_measures.h"
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
    while (static_cast<int>(chosen.size()) < count && !points.empty()) {
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

double evenRadius(const Discretisation& solid, int count) {
    double area = 0;
    for (const SurfacePoint& point : solid.surface_points)
        if (const double own = point.area.norm(); own > 0) area += own;  // also none that is no number
    return std::sqrt(area / (pi * count));
}

std::vector<UnitPatch> unitPatches(const Discretisation& solid, int count, double radius_m) {
    std::vector<Vec3> positions, normals;
    std::vector<double> areas;
    for (const SurfacePoint& point : solid.surface_points) {
        const double own = point.area.norm();
        if (!(own > 0)) continue;
        positions.push_back(point.position);
        normals.push_back(point.area / own);
        areas.push_back(own);
    }
    const double radius = radius_m > 0 ? radius_m : evenRadius(solid, count);
    std::vector<UnitPatch> patches;
    for (const int middle : spreadOut(positions, count)) {
        UnitPatch patch;
        patch.middle = positions[middle];
        patch.inward = -normals[middle];
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

std::vector<UnitPatch> edgePatches(const Discretisation& solid, int count, double radius_m) {
    constexpr double sharp = 0.77;  // cosine between the faces' normals
    const TriangleMesh& surface = *solid.surface;
    std::vector<std::vector<Vec3>> normals(surface.vertices.size());
    std::vector<Vec3> means(surface.vertices.size(), Vec3::Zero());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const Vec3 area = areaVector(cornersOf(surface, static_cast<int>(t)));
        if (!(area.norm() > 0)) continue;
        for (const int v : surface.triangles[t]) {
            normals[v].push_back(area.normalized());
            means[v] += area;
        }
    }
    std::vector<Vec3> positions, inwards;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        double least = 1;
        for (const Vec3& a : normals[v])
            for (const Vec3& b : normals[v]) least = std::min(least, a.dot(b));
        if (least > sharp || !(means[v].norm() > 0)) continue;
        positions.push_back(surface.vertices[v]);
        inwards.push_back(-means[v].normalized());
    }
    std::vector<UnitPatch> patches;
    for (const int corner : spreadOut(positions, count)) {
        UnitPatch patch;
        patch.middle = positions[corner];
        patch.inward = inwards[corner];
        patch.on_edge = true;
        double sum = 0;
        for (const SurfacePoint& point : solid.surface_points) {
            if ((point.position - patch.middle).squaredNorm() > radius_m * radius_m) continue;
            if (!(point.area.dot(patch.inward) < 0)) continue;
            patch.points.push_back({point.position, point.area.norm()});
            sum += point.area.norm();
        }
        for (UnitPatch::Point& point : patch.points) point.weight /= sum;
        if (patch.points.empty() || radius_m < 0.5 * solid.spacing) patch.points = {{patch.middle, 1}};
        patches.push_back(std::move(patch));
    }
    return patches;
}

}  // namespace sherd
