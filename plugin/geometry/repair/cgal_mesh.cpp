#include "geometry/repair/cgal_mesh.h"

#include <unordered_map>

#include "geometry/surface_mesh_conversion.h"

namespace sherd {

RepairMesh toRepairMesh(const TriangleMesh& mesh) {
    return toSurfaceMesh<RepairMesh>(mesh);
}

TriangleMesh toTriangleMesh(const RepairMesh& mesh) {
    return fromSurfaceMesh(mesh);
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
