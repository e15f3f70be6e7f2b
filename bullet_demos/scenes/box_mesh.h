#pragma once

#include <sherd/triangle_mesh.h>

#include "scene.h"

namespace demo {

/// The closed surface of a box: a regular grid of triangles on each side, shared vertices on the edges.
sherd::TriangleMesh boxMesh(const Box& box);

}  // namespace demo
