#pragma once

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// CGAL's search tree over the triangles of a mesh. Triangles keep the mesh's order.
struct TriangleTree {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Triangles = std::vector<Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

    Triangles triangles;
    Tree tree;

    explicit TriangleTree(const TriangleMesh& mesh)
        : triangles(trianglesOf(mesh)), tree(triangles.cbegin(), triangles.cend()) {}

    int indexOf(Triangles::const_iterator triangle) const {
        return static_cast<int>(triangle - triangles.cbegin());
    }
    static Kernel::Point_3 toPoint(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
    static Vec3 toVec3(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

  private:
    static Triangles trianglesOf(const TriangleMesh& mesh) {
        Triangles triangles;
        triangles.reserve(mesh.triangles.size());
        for (const auto& [a, b, c] : mesh.triangles)
            triangles.emplace_back(toPoint(mesh.vertices[a]), toPoint(mesh.vertices[b]),
                                   toPoint(mesh.vertices[c]));
        return triangles;
    }
};

}  // namespace sherd
