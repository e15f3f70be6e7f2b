#include "geometry/merge_vertices.h"

#include <algorithm>
#include <numeric>

#include "geometry/by_position.h"
#include "geometry/mesh_attributes.h"

namespace sherd {
namespace {

/// For every vertex the first one at the same position.
std::vector<int> firstAtPosition(const std::vector<Vec3>& vertices) {
    std::vector<int> order(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return precedes(vertices[a], vertices[b]); });
    std::vector<int> first(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// The mean colour of the vertices that became each one.
std::vector<Vec3> meanColours(const TriangleMesh& mesh, const std::vector<int>& renumbered,
                              std::size_t count) {
    std::vector<Vec3> colours(count, Vec3::Zero());
    std::vector<int> shares(count, 0);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (renumbered[v] < 0) continue;
        colours[renumbered[v]] += mesh.colours[v];
        ++shares[renumbered[v]];
    }
    for (std::size_t v = 0; v < count; ++v) colours[v] /= shares[v];
    return colours;
}

}  // namespace

TriangleMesh mergeEqualVertices(const TriangleMesh& mesh) {
    const std::vector<int> first = firstAtPosition(mesh.vertices);
    TriangleMesh merged;
    merged.materials = mesh.materials;
    std::vector<int> used(mesh.vertices.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::array<int, 3> triangle = {first[a], first[b], first[c]};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
        merged.triangles.push_back(triangle);
        if (!mesh.kinds.empty()) merged.kinds.push_back(mesh.kinds[t]);
        if (!mesh.file_faces.empty()) merged.file_faces.push_back(mesh.file_faces[t]);
        copyCorners(mesh, static_cast<int>(t), merged);
        for (const int corner : triangle) used[corner] = 1;
    }
    std::vector<int> renumbered(mesh.vertices.size(), -1);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (!used[v]) continue;
        renumbered[v] = static_cast<int>(merged.vertices.size());
        merged.vertices.push_back(mesh.vertices[v]);
    }
    for (auto& triangle : merged.triangles)
        for (int& corner : triangle) corner = renumbered[corner];
    if (mesh.colours.empty()) return merged;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) renumbered[v] = renumbered[first[v]];
    merged.colours = meanColours(mesh, renumbered, merged.vertices.size());
    return merged;
}

}  // namespace sherd
