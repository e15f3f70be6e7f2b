#include "geometry/surface_normals.h"

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

}  // namespace

std::vector<Vec3> surfaceNormals(const TriangleMesh& mesh, const std::vector<Vec3>& points, double tolerance) {
    std::vector<Vec3> normals(points.size(), Vec3::Zero());
    if (points.empty()) return normals;
    const auto corner = [&](int v) {
        const Vec3& x = mesh.vertices[v];
        return Kernel::Point_3(x.x(), x.y(), x.z());
    };
    Triangles triangles;
    for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(corner(a), corner(b), corner(c));
    const Tree tree(triangles.cbegin(), triangles.cend());

    std::vector<Triangles::const_iterator> near;
    for (std::size_t i = 0; i < points.size(); ++i) {
        near.clear();
        const Kernel::Point_3 centre(points[i].x(), points[i].y(), points[i].z());
        tree.all_intersected_primitives(Kernel::Sphere_3(centre, tolerance * tolerance), std::back_inserter(near));
        if (near.empty()) continue;
        std::sort(near.begin(), near.end());  // the same sum in the same order, whatever the tree
        const Vec3 first = normalOf(*near.front());
        Vec3 sum = Vec3::Zero();
        bool smooth = true;
        for (const auto& triangle : near) {
            const Vec3 normal = normalOf(*triangle);
            smooth = smooth && normal.dot(first) > one_side;
            sum += normal;
        }
        if (smooth) normals[i] = sum.normalized();
    }
    return normals;
}

}  // namespace sherd
