#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// Walls of a sheet: itself, facing outward, a copy of which all faces lie deeper by `thickness` (m), and
/// rims between the borders of both (CGAL's extrusion). Where the sheet is curved more tightly than it is to
/// be thick, the walls cross. It has to be a manifold.
TriangleMesh thickened(const TriangleMesh& sheet, double thickness);

/// Whether a manifold is open somewhere.
bool hasBorder(const TriangleMesh& mesh);

}  // namespace sherd
