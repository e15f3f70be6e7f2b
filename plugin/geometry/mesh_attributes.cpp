#include "geometry/mesh_attributes.h"

#include <algorithm>

namespace sherd {

bool hasAttributes(const TriangleMesh& mesh) {
    return !mesh.texture_coordinates.empty() || !mesh.normals.empty() || !mesh.material.empty() ||
           !mesh.colours.empty();
}

void copyCorners(const TriangleMesh& from, int triangle, TriangleMesh& to) {
    if (!from.texture_coordinates.empty())
        to.texture_coordinates.push_back(from.texture_coordinates[triangle]);
    if (!from.normals.empty()) to.normals.push_back(from.normals[triangle]);
    if (!from.material.empty()) to.material.push_back(from.material[triangle]);
}

int findOrAddMaterial(TriangleMesh& mesh, const std::string& name) {
    const auto found = std::find(mesh.materials.begin(), mesh.materials.end(), name);
    const int index = static_cast<int>(found - mesh.materials.begin());
    if (found == mesh.materials.end()) mesh.materials.push_back(name);
    return index;
}

}  // namespace sherd
