#include "geometry/exact_union.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes the empty callback of CGAL's self-intersection test, which is never called here, for an unset
// value.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Polygon_mesh_processing/corefinement.h>

namespace sherd {

std::optional<ExactMesh> unionOf(ExactMesh a, ExactMesh b) {  // which are split along each other
    ExactMesh both;
    if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(a, b, both)) return std::nullopt;
    return both;
}

}  // namespace sherd
