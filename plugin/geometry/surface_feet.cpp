#include "geometry/surface_feet.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "geometry/triangle_tree.h"

namespace sherd {
namespace {

using Kernel = TriangleTree::Kernel;

constexpr double one_side = 0.94;  // cosine (20 degrees) between facets of what counts as one smooth side

Vec3 normalOf(const Kernel::Triangle_3& triangle) {
    const Kernel::Vector_3 normal = CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    return Vec3(normal.x(), normal.y(), normal.z()).normalized();
}

/// Sum of the normals of the facets within `tolerance`, and whether they lie on one smooth side.
std::pair<Vec3, bool> normalAt(const TriangleTree& surface, const Kernel::Point_3& foot, double tolerance) {
    std::vector<TriangleTree::Triangles::const_iterator> near;
    surface.tree.all_intersected_primitives(Kernel::Sphere_3(foot, tolerance * tolerance),
                                            std::back_inserter(near));
    std::sort(near.begin(), near.end());  // the same sum in the same order, whatever the tree
    Vec3 sum = Vec3::Zero();
    bool smooth = !near.empty();
    for (const auto& triangle : near) {
        const Vec3 normal = normalOf(*triangle);
        smooth = smooth && normal.dot(normalOf(*near.front())) > one_side;
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
        const auto [nearest, triangle] = surface.tree.closest_point_and_primitive(TriangleTree::toPoint(x));
        SurfaceFoot foot;
        foot.position = TriangleTree::toVec3(nearest);
        foot.distance = (foot.position - x).norm();
        foot.triangle = surface.indexOf(triangle);
        const auto [normal, smooth] = normalAt(surface, nearest, tolerance);
        if (smooth) foot.normal = normal.normalized();
        foot.outside = (x - foot.position).dot(normal) > 0;
        feet.push_back(foot);
    }
    return feet;
}

}  // namespace sherd
