#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// Gives `mesh` the normals, texture coordinates, materials and colours that `original` has. A triangle whose
/// corners are those of one of `original` takes that one's values bit for bit; others take them from the
/// nearest points: the material from that of the triangle's middle, values of each corner from a point just
/// inside it, and texture coordinates continued from the middle where that point is beyond a seam.
void carryLook(const TriangleMesh& original, TriangleMesh& mesh);

}  // namespace sherd
