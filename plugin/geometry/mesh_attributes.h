#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// Whether a mesh has anything beyond its triangles and their kinds.
bool hasAttributes(const TriangleMesh& mesh);

/// Appends what a triangle of one mesh has at its corners, and its material, to another one with the same
/// materials.
void copyCorners(const TriangleMesh& from, int triangle, TriangleMesh& to);

/// The index of a material, which is added if there is none of that name.
int findOrAddMaterial(TriangleMesh& mesh, const std::string& name);

}  // namespace sherd
