#pragma once

#include <sherd/triangle_mesh.h>

#include <cstdint>
#include <vector>

namespace demo {

/// A vertex as graphics hardware has it: one for each normal and each kind of face at a place.
struct DrawnVertex {
    sherd::Vec3 position;
    sherd::Vec3 normal;
    sherd::SurfaceKind kind;
};

/// A surface to be drawn with smooth outside faces and flat crack faces. Three indices are a triangle,
/// counter-clockwise seen from outside.
struct DrawnMesh {
    std::vector<DrawnVertex> vertices;
    std::vector<std::uint32_t> outside, crack;
};

DrawnMesh drawnMesh(const sherd::TriangleMesh& mesh);

}  // namespace demo
