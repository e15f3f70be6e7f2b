#include "geometry/surface_feet.h"

#include <utility>

#include "core/numerics/mesh_measures.h"
#include "geometry/triangle_tree.h"

namespace sherd {
namespace {

constexpr double one_side = 0.94;  // cosine (20 degrees) between facets of what counts as one smooth side

/// Sum of the normals of the facets within `tolerance`, and whether they lie on one smooth side.
std::pair<Vec3, bool> normalAt(const TriangleMesh& mesh, const TriangleTree& surface, const Vec3& foot,
                               double tolerance) {
    const auto normalOf = [&](int triangle) {
        return areaVector(cornersOf(mesh, static_cast<std::size_t>(triangle))).normalized();
    };
    const std::vector<int> near = surface.within(tolerance, foot);
    Vec3 sum = Vec3::Zero();
    bool smooth = !near.empty();
    for (const int triangle : near) {
        const Vec3 normal = normalOf(triangle);
        smooth = smooth && normal.dot(normalOf(near.front())) > one_side;
        sum += normal;
    }
    return {sum, smooth};
}

}  // namespace

std::vector<SurfaceFoot> surfaceFeet(const TriangleMesh& mesh, const std::vector<Vec3>& points,
                                     double tolerance) {
    std::vector<SurfaceFoot> feet;
    if (points.empty()) return feet;
    const TriangleTree surface(mesh);
    for (const Vec3& x : points) {
        const TriangleTree::Foot nearest = surface.nearest(x);
        SurfaceFoot foot;
        foot.position = nearest.position;
        foot.triangle = nearest.triangle;
        foot.distance = (foot.position - x).norm();
        const auto [normal, smooth] = normalAt(mesh, surface, foot.position, tolerance);
        if (smooth) foot.normal = normal.normalized();
        foot.outside = (x - foot.position).dot(normal) > 0;
        feet.push_back(foot);
    }
    return feet;
}

}  // namespace sherd
