#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// Corners of the faces on which a body can stand, where several of them lie in one plane, as feet do: the
/// inner corners of feet are no vertices of the body's hull. Empty for bodies without feet. `hull`: the
/// vertices of the body's convex hull, m. `tolerance_m`: how far vertices may be from a plane and lie in it.
std::vector<Vec3> cornersOfFeet(const TriangleMesh& surface, const std::vector<Vec3>& hull,
                                double tolerance_m);

}  // namespace sherd
