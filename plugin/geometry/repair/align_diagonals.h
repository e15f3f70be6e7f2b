#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// Two walls that lie on each other are often the same quadrilaterals split along other diagonals, since
/// every exporter starts a face at a corner of its own. Splits the second as the first, so that their
/// triangles are the same. Corners lie in one plane within `tolerance` (m).
void alignDiagonals(TriangleMesh& mesh, double tolerance);

}  // namespace sherd
