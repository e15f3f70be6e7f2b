#include "geometry/repair/cgal_mesh.h"

#include <unordered_map>

namespace sherd {

RepairMesh toRepairMesh(const TriangleMesh& mesh) {
    RepairMesh result;
    for (const Vec3& v : mesh.vertices) result.add_vertex({v.x(), v.y(), v.z()});
    for (const auto& [a, b, c] : mesh.triangles)
        result.add_face(RepairMesh::Vertex_index(a), RepairMesh::Vertex_index(b),
                        RepairMesh::Vertex_index(c));
    return result;
}

TriangleMesh toTriangleMesh(const RepairMesh& mesh) {
    TriangleMesh result;
    std::vector<int> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), -1);
    for (const auto vertex : mesh.vertices()) {
        if (mesh.is_isolated(vertex)) continue;
        number[vertex] = static_cast<int>(result.vertices.size());
        const auto& p = mesh.point(vertex);
        result.vertices.emplace_back(p.x(), p.y(), p.z());
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

TriangleMesh partOf(const TriangleMesh& mesh, const std::vector<int>& triangles) {
    TriangleMesh part;
    std::unordered_map<int, int> number;  // for look-up only; never iterated over
    for (const int t : triangles) {
        std::array<int, 3> triangle = mesh.triangles[t];
        for (int& corner : triangle) {
            const auto [entry, is_new] = number.try_emplace(corner, static_cast<int>(part.vertices.size()));
            if (is_new) part.vertices.push_back(mesh.vertices[corner]);
            corner = entry->second;
        }
        part.triangles.push_back(triangle);
    }
    return part;
}

void append(const TriangleMesh& part, TriangleMesh& mesh) {
    const int offset = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [a, b, c] : part.triangles)
        mesh.triangles.push_back({a + offset, b + offset, c + offset});
}

}  // namespace sherd
