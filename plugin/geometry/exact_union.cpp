#include "geometry/exact_union.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes the empty callback of CGAL's self-intersection test, which is never called here, for an unset
// value.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Polygon_mesh_processing/corefinement.h>

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

}  // namespace sherd
