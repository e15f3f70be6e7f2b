#include "geometry/surface_feet.h"

#include <algorithm>
#include <iterator>

#include "geometry/triangle_tree.h"

namespace sherd {
namespace {

using Kernel = TriangleTree::Kernel;

constexpr double one_side = 0.94;  // cosine (20 degrees) between facets of what counts as one smooth side

Vec3 normalOf(const Kernel::Triangle_3& triangle) {
    const Kernel::Vector_3 normal = CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    return Vec3(normal.x(), normal.y(), normal.z()).normalized();
}

/// Mean of the facets within `tolerance`; zero if they lie on different sides.
Vec3 smoothNormal(const TriangleTree& surface, const Kernel::Point_3& foot, double tolerance) {
    std::vector<TriangleTree::Triangles::const_iterator> near;
    surface.tree.all_intersected_primitives(Kernel::Sphere_3(foot, tolerance * tolerance), std::back_inserter(near));
    std::sort(near.begin(), near.end());  // the same sum in the same order, whatever the tree
    Vec3 sum = Vec3::Zero();
    for (const auto& triangle : near) {
        const Vec3 normal = normalOf(*triangle);
        if (normal.dot(normalOf(*near.front())) < one_side) return Vec3::Zero();
        sum += normal;
    }
    return sum.normalized();
}

}  // namespace

std::vector<SurfaceFoot> surfaceFeet(const TriangleMesh& mesh, const std::vector<Vec3>& points, double tolerance) {
    std::vector<SurfaceFoot> feet;
    if (points.empty()) return feet;
    const TriangleTree surface(mesh);
    for (const Vec3& x : points) {
        const Kernel::Point_3 nearest = surface.tree.closest_point(TriangleTree::toPoint(x));
        const Vec3 position = TriangleTree::toVec3(nearest);
        feet.push_back({position, smoothNormal(surface, nearest, tolerance), (position - x).norm()});
    }
    return feet;
}

}  // namespace sherd
