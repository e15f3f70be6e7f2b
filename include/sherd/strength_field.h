#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>
#include <sherd/types.h>

#include <functional>

namespace sherd {

/// A strength field (FractureSettings::strength_field) from a painted mesh: at x, the colour of the nearest
/// point of the surface, the mean of its red, green and blue, goes from `black` (what the strength is
/// multiplied with where the mesh is black) to `white`, and is nowhere below the smaller of the two
/// (FractureSettings::strength_field_minimum). Both above 0. The error says what is wrong: a mesh
/// without colours, or a factor out of range.
Result<std::function<double(const Vec3& x)>> strengthFromColours(const TriangleMesh& painted, double black,
                                                                 double white);

}  // namespace sherd
