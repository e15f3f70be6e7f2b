#pragma once

#include <sherd/triangle_mesh.h>

#include <array>
#include <vector>

namespace demo {

/// Unit normals for shading, one at each corner of each triangle (#T x 3). Original faces are smooth over
/// edges flatter than `crease_deg`; crack faces are flat.
std::vector<std::array<sherd::Vec3, 3>> cornerNormals(const sherd::TriangleMesh& mesh, double crease_deg);

}  // namespace demo
