#pragma once

#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>
#include <sherd/triangle_mesh.h>

#include <array>
#include <vector>

namespace sherd {

/// Vertices and triangles as a half-edge mesh of CGAL's, in the same order. Triangles that no manifold can
/// have are left out.
template <class SurfaceMesh>
SurfaceMesh toSurfaceMesh(const TriangleMesh& mesh) {
    using Vertex = typename SurfaceMesh::Vertex_index;
    SurfaceMesh result;
    for (const Vec3& v : mesh.vertices) result.add_vertex({v.x(), v.y(), v.z()});
    for (const auto& [a, b, c] : mesh.triangles) result.add_face(Vertex(a), Vertex(b), Vertex(c));
    return result;
}

/// The nearest double: that of an interval depends on what of a number was worked out before.
template <class Number>
double nearestDouble(const Number& number) {
    return CGAL::to_double(CGAL::exact(number));
}

/// The vertices that triangles use, rounded to double precision, and the triangles, in order.
template <class SurfaceMesh>
TriangleMesh fromSurfaceMesh(const SurfaceMesh& mesh) {
    TriangleMesh result;
    std::vector<int> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1);
    for (const auto vertex : mesh.vertices()) {
        if (mesh.is_isolated(vertex)) continue;
        number[vertex] = static_cast<int>(result.vertices.size());
        const auto& p = mesh.point(vertex);
        result.vertices.emplace_back(nearestDouble(p.x()), nearestDouble(p.y()), nearestDouble(p.z()));
    }
    for (const auto face : mesh.faces()) {
        std::array<int, 3> triangle{};
        int k = 0;
        for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            triangle[k++] = number[vertex];
        result.triangles.push_back(triangle);
    }
    return result;
}

}  // namespace sherd
