#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

namespace sherd {

/// Closed, oriented outward, finite, not empty, not self-intersecting, of one or more parts (CGAL). The error
/// says which of these fails, at which triangle or edge and where in space, and what to do.
Status checkSurface(const TriangleMesh& mesh);

/// A small percentile of the wall thickness seen by rays shot inward from the triangles, m; 0 if no ray meets
/// a wall.
double wallThickness(const TriangleMesh& mesh);

}  // namespace sherd
