#include <array>
#include <string>
#include <vector>

#include "geometry/surface_checks.h"
#include "geometry/surface_topology.h"

namespace sherd {
namespace {

constexpr double largest_coordinate_m = 1e9;  // volumes and moments of larger ones lose all digits

Status checkPositions(const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        return Error{"The surface is empty: it has no triangles; give the closed surface of a solid."};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const bool finite = mesh.vertices[v].allFinite();
        if (finite && mesh.vertices[v].cwiseAbs().maxCoeff() <= largest_coordinate_m) continue;
        return Error{"Vertex " + std::to_string(v) + " of the surface is at " +
                     describePlace(mesh.vertices[v]) + ", which is " +
                     (finite ? "more than 1e9 m away; correct its coordinates, or scale the mesh to metres."
                             : "not finite; correct its coordinates.")};
    }
    const int count = static_cast<int>(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int corner : mesh.triangles[t])
            if (corner < 0 || corner >= count)
                return Error{"Triangle " + std::to_string(t) + " of the surface names vertex " +
                             std::to_string(corner) + ", but vertices are numbered 0 to " +
                             std::to_string(count - 1) + "; correct the number."};
    return success();
}

/// A list that has to have one entry a triangle or a vertex, if any.
Status checkCount(const char* name, std::size_t count, std::size_t expected) {
    if (count == 0 || count == expected) return success();
    return Error{std::string("The surface has ") + std::to_string(count) + " entries in " + name + ", but " +
                 std::to_string(expected) + " are needed; give all or none."};
}

/// Numbers at the corners of triangles.
template <class Vector>
Status checkCorners(const char* name, const std::vector<std::array<Vector, 3>>& corners) {
    for (std::size_t t = 0; t < corners.size(); ++t)
        for (const Vector& corner : corners[t])
            if (!corner.allFinite())
                return Error{
                    std::string("The ") + name + " of triangle " + std::to_string(t) +
                    " of the surface are not finite numbers; correct them, or leave the list empty."};
    return success();
}

Status checkAttributes(const TriangleMesh& mesh) {
    const std::size_t triangles = mesh.triangles.size();
    if (Status s = checkCount("kinds", mesh.kinds.size(), triangles); !s) return s;
    if (Status s = checkCount("file_faces", mesh.file_faces.size(), triangles); !s) return s;
    if (Status s = checkCount("texture_coordinates", mesh.texture_coordinates.size(), triangles); !s)
        return s;
    if (Status s = checkCount("normals", mesh.normals.size(), triangles); !s) return s;
    if (Status s = checkCount("material", mesh.material.size(), triangles); !s) return s;
    if (Status s = checkCorners("texture coordinates", mesh.texture_coordinates); !s) return s;
    if (Status s = checkCorners("normals", mesh.normals); !s) return s;
    for (const int material : mesh.material)
        if (material < 0 || material >= static_cast<int>(mesh.materials.size()))
            return Error{"A triangle of the surface names material " + std::to_string(material) + ", but " +
                         std::to_string(mesh.materials.size()) + " are named; correct the number."};
    for (std::size_t v = 0; v < mesh.colours.size(); ++v)
        if (!mesh.colours[v].allFinite())
            return Error{"The colour of vertex " + std::to_string(v) +
                         " of the surface is not a finite number; correct it."};
    return checkCount("colours", mesh.colours.size(), mesh.vertices.size());
}

}  // namespace

Status checkNumbers(const TriangleMesh& mesh) {
    if (Status positions = checkPositions(mesh); !positions) return positions;
    return checkAttributes(mesh);
}

}  // namespace sherd
