#pragma once

#include <sherd/triangle_mesh.h>

#include <string>

namespace sherd::fragment_support {

/// What CGAL finds wrong with a piece: not manifold, open, not connected to bound a volume, inward, a
/// triangle of no area, a doubled triangle, self-intersection. Empty: nothing.
std::string faultOf(const TriangleMesh& mesh);

}  // namespace sherd::fragment_support
