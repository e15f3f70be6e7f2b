#pragma once

#include <sherd/triangle_mesh.h>

#include "scenes/scene.h"

namespace demo {

/// The closed surface of a box: a regular grid of triangles on each side, shared vertices on the edges.
sherd::TriangleMesh boxMesh(const Box& box);

/// The `edge_m` with which a box of that size comes near so many triangles.
double boxEdge(const Vec3& size_m, int triangles);

}  // namespace demo
