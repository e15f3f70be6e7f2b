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

/// A triangle surface. For a breakable body it is closed, oriented outward and free of self-intersection.
struct TriangleMesh {
    std::vector<Vec3> vertices;                 ///< #V points, m
    std::vector<std::array<int, 3>> triangles;  ///< #T, counter-clockwise seen from outside
    std::vector<SurfaceKind> kinds;             ///< #T, or empty: all original
};

/// Reads the `v` and `f` records of a Wavefront OBJ (polygons are split into triangles, texture and normal
/// indices are ignored, vertices at the same position become one). The error names the file and the line.
Result<TriangleMesh> readObj(const std::string& path);

/// Writes vertices with up to 17 digits, so that reading them gives the same bits; crack faces are in the
/// group `crack`.
Status writeObj(const TriangleMesh& mesh, const std::string& path);

}  // namespace sherd
