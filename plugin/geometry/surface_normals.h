#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// Outward unit normals of the surface at `points`, #points: zero for points further than `tolerance` from it, and for
/// those so near an edge or a corner that it has none.
std::vector<Vec3> surfaceNormals(const TriangleMesh& mesh, const std::vector<Vec3>& points, double tolerance);

}  // namespace sherd
