#include "geometry/surface_feet.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <iterator>

namespace sherd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

constexpr double one_side = 0.94;  // cosine (20 degrees) between facets of what counts as one smooth side

Vec3 normalOf(const Kernel::Triangle_3& triangle) {
    const Kernel::Vector_3 normal = CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    return Vec3(normal.x(), normal.y(), normal.z()).normalized();
}

Kernel::Point_3 toPoint(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// Mean of the facets within `tolerance`; zero if they lie on different sides.
Vec3 smoothNormal(const Tree& tree, const Kernel::Point_3& foot, double tolerance) {
    std::vector<Triangles::const_iterator> near;
    tree.all_intersected_primitives(Kernel::Sphere_3(foot, tolerance * tolerance), std::back_inserter(near));
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
    Triangles triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.emplace_back(toPoint(mesh.vertices[a]), toPoint(mesh.vertices[b]), toPoint(mesh.vertices[c]));
    const Tree tree(triangles.cbegin(), triangles.cend());
    for (const Vec3& x : points) {
        const Kernel::Point_3 nearest = tree.closest_point(toPoint(x));
        const Vec3 position(nearest.x(), nearest.y(), nearest.z());
        feet.push_back({position, smoothNormal(tree, nearest, tolerance), (position - x).norm()});
    }
    return feet;
}

}  // namespace sherd
