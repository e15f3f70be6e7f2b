#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#include "core/numerics/mesh_measures.h"
#include "geometry/surface_checks.h"
#include "geometry/triangle_tree.h"

namespace sherd {
namespace {

constexpr int ray_count = 2000;
// So that a thin wall counts if it has a tenth of the surface, and a sharp edge does not.
constexpr double percentile = 0.1;

struct Ray {
    std::size_t triangle;
    Vec3 origin, direction;
};

/// Rays that each stand for the same share of the surface, so that a large triangle gets several.
std::vector<Ray> inwardRays(const TriangleMesh& mesh) {
    double total = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) total += areaVector(cornersOf(mesh, t)).norm();
    std::vector<Ray> rays;
    double passed = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 area = areaVector(cornersOf(mesh, t));
        passed += area.norm();
        while (rays.size() < ray_count && passed > (rays.size() + 0.5) / ray_count * total) {
            // The R2 sequence, folded into the triangle; shrunk so that no ray starts on an edge.
            const double index = static_cast<double>(rays.size() + 1);
            double u = std::fmod(0.7548776662466927 * index, 1), v = std::fmod(0.5698402909980532 * index, 1);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            u = 0.02 + 0.94 * u, v = 0.02 + 0.94 * v;
            const auto& [a, b, c] = mesh.triangles[t];
            const Vec3 origin = (1 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] + v * mesh.vertices[c];
            rays.push_back({t, origin, -area.normalized()});
        }
    }
    return rays;
}

double thicknessByRays(const TriangleMesh& mesh) {
    const TriangleTree surface(mesh);
    std::vector<double> distances;
    for (const Ray& ray : inwardRays(mesh)) {
        const auto hit =
            surface.firstHit(ray.origin, ray.origin + ray.direction, static_cast<int>(ray.triangle));
        if (hit && hit->place) distances.push_back((*hit->place - ray.origin).norm());
    }
    if (distances.empty()) return 0;
    const auto thin =
        distances.begin() + static_cast<std::ptrdiff_t>(percentile * static_cast<double>(distances.size()));
    std::nth_element(distances.begin(), thin, distances.end());
    return *thin;
}

}  // namespace

double wallThickness(const TriangleMesh& mesh) {
    try {
        return thicknessByRays(mesh);
    } catch (const std::exception&) {
        return 0;
    }
}

}  // namespace sherd
