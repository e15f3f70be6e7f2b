#pragma once

#include <sherd/types.h>

#include "core/numerics/mesh_measures.h"

namespace sherd {

/// The half-space of the points x with normal . x <= offset.
struct HalfSpace {
    Vec3 normal = Vec3::UnitZ();
    double offset_m = 0;
};

/// Area of the part of a triangle that lies in a ball and in a half-space, m^2, exactly.
double capArea(const TriangleCorners& triangle, const Vec3& centre, double radius, const HalfSpace& below);

}  // namespace sherd
