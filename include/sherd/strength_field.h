#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>
#include <sherd/types.h>

#include <functional>

namespace sherd {

/// A strength field (StrengthSettings::field) from a mesh with painted vertices. With b the mean of
/// red, green and blue at the nearest point of the surface, the strength at x is multiplied with
/// black + (white - black) b. The smaller of the two, which must be above 0, serves as
/// StrengthSettings::field_minimum. The error says what is wrong: a mesh without colours, or a
/// factor out of range.
Result<std::function<double(const Vec3& x)>> strengthFromColours(const TriangleMesh& painted, double black,
                                                                 double white);

}  // namespace sherd
