#pragma once

#include <sherd/repair.h>

namespace sherd {

/// Makes a manifold, with or without borders, of a surface that touches itself in edges or points: around an
/// edge of several triangles those that bound the same wedge of material are joined, and every fan of
/// triangles around a vertex gets a vertex of its own. Where that parts something, the parts are drawn back
/// into their material by a thousandth of their edges, so that they do not touch. Edges without such a pair
/// (a flap, triangles turned against each other) become borders.
void partTouching(TriangleMesh& mesh, RepairReport& report);

}  // namespace sherd
