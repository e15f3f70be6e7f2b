#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// One vertex for each position, none that no triangle uses, no triangle that has a corner twice. The order
/// of vertices and triangles stays, and so do the attributes of their corners; a vertex gets the mean colour
/// of those it stands for. OBJ files often repeat a position for every normal or texture coordinate that
/// meets there.
TriangleMesh mergeEqualVertices(const TriangleMesh& mesh);

}  // namespace sherd
