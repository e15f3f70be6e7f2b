#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>
#include <sherd/types.h>

#include <functional>

namespace sherd {

/// A strength field (FractureSettings::strength_field) from a mesh with painted vertices. The strength at x
/// is multiplied with `black` where the nearest point of the surface is black, with `white` where it is
/// white, and with what lies between, by the mean of red, green and blue, elsewhere: it is nowhere below
/// the smaller of the two (FractureSettings::strength_field_minimum). Both factors are above
/// 0. The error says what is wrong: a mesh without colours, or a factor out of range.
Result<std::function<double(const Vec3& x)>> strengthFromColours(const TriangleMesh& painted, double black,
                                                                 double white);

}  // namespace sherd
