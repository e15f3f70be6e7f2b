#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sherd {

/// What a triangle of a fragment's surface is: part of the body's first surface, or a face that a crack made.
enum class SurfaceKind : std::uint8_t { original, crack };

/// The axis of a mesh file that points up. Sherd's own is z.
enum class UpAxis : std::uint8_t { x, y, z };

/// A triangle surface. For a breakable body it is closed, oriented outward and free of self-intersection; it
/// may have several parts, and cavities (oriented into the hollow).
/// Below, V is the number of vertices, T that of triangles.
struct TriangleMesh {
    std::vector<Vec3> vertices;                 ///< V points, m
    std::vector<std::array<int, 3>> triangles;  ///< T, three vertices, counter-clockwise seen from outside
    std::vector<SurfaceKind> kinds;             ///< T; empty: all are original
    /// T, the face of the file that each triangle came from, counted from 1; empty for other meshes.
    std::vector<int> file_faces;

    // What a renderer wants to know. Each is empty where a mesh has none of it. Fragments keep it: triangles
    // that no crack crosses have what they had, parts of crossed ones have it interpolated.
    std::vector<std::array<Vec2, 3>> texture_coordinates;  ///< T, at the corners; on crack faces in m
    std::vector<std::array<Vec3, 3>> normals;  ///< T, at the corners; zero where the mesh gives none
    std::vector<int> material;                 ///< T, index into `materials`
    std::vector<std::string> materials;        ///< names; crack faces have one called `crack`
    std::vector<Vec3> colours;                 ///< V, red, green and blue from 0 to 1
};

/// A box about the origin, 12 triangles: how fine a body is sampled does not depend on its surface. Its sizes
/// are to be positive.
TriangleMesh boxMesh(const Vec3& size_m);

/// An upright cylinder about the origin, with so many sides; fewer than 3 are 3.
TriangleMesh cylinderMesh(double radius_m, double height_m, int sides = 32);

/// Reads a Wavefront OBJ: `v` (with a colour, if three numbers from 0 to 1 follow the position), `vt`, `vn`,
/// `f`, `usemtl` and the group `crack`. Polygons are split into triangles. Vertices at the same position
/// become one, which has their mean colour; texture coordinates and normals belong to corners, so seams stay.
/// Corners without texture coordinates or a normal get zeros if others have some, vertices without a colour
/// are white. Coordinates are multiplied with `scale`, to be metres, and the mesh is turned so that
/// `up_axis` becomes z. The error names the file and the lines.
Result<TriangleMesh> readObj(const std::string& path, double scale = 1, UpAxis up_axis = UpAxis::z);

/// Writes numbers with up to 17 digits, so that reading them gives the same bits; crack faces are in the
/// group `crack`. Materials are named (`usemtl`), not described: there is no MTL file.
Status writeObj(const TriangleMesh& mesh, const std::string& path);

}  // namespace sherd
