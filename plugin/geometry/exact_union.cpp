#include "geometry/exact_union.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes the empty callback of CGAL's self-intersection test, which is never called here, for an unset
// value.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "geometry/by_position.h"
#include "geometry/merge_vertices.h"
#include "geometry/surface_mesh_conversion.h"

namespace sherd {

namespace {

bool isSolid(const ExactMesh& mesh) {
    return mesh.is_valid(false) && CGAL::is_triangle_mesh(mesh) && CGAL::is_closed(mesh);
}

}  // namespace

std::optional<ExactMesh> unionOf(ExactMesh a, ExactMesh b) {  // which are split along each other
    // What is no closed manifold, since triangles of it were left out, leaves a union with wild indices.
    if (!isSolid(a) || !isSolid(b)) return std::nullopt;
    ExactMesh both;
    if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(a, b, both)) return std::nullopt;
    if (!isSolid(both)) return std::nullopt;
    return both;
}

TriangleMesh roundedMesh(const ExactMesh& mesh) {
    const TriangleMesh merged = mergeEqualVertices(fromSurfaceMesh(mesh));
    std::vector<int> old(merged.vertices.size());
    std::iota(old.begin(), old.end(), 0);
    std::sort(old.begin(), old.end(),
              [&](int a, int b) { return precedes(merged.vertices[a], merged.vertices[b]); });
    TriangleMesh ordered;
    std::vector<int> number(old.size());
    for (const int vertex : old) {
        number[vertex] = static_cast<int>(ordered.vertices.size());
        ordered.vertices.push_back(merged.vertices[vertex]);
    }
    for (auto triangle : merged.triangles) {
        for (int& corner : triangle) corner = number[corner];
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        ordered.triangles.push_back(triangle);
    }
    std::sort(ordered.triangles.begin(), ordered.triangles.end());
    return ordered;
}

}  // namespace sherd
