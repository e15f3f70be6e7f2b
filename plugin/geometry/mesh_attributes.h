#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// Whether a mesh has normals, texture coordinates, materials or colours.
bool hasAttributes(const TriangleMesh& mesh);

/// Appends the attributes of a triangle's corners, and its material, to another mesh with the same materials.
void copyCorners(const TriangleMesh& from, int triangle, TriangleMesh& to);

/// The index of the material of a name, which is added if there is none.
int findOrAddMaterial(TriangleMesh& mesh, const std::string& name);

}  // namespace sherd
