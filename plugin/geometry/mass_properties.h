#pragma once

#include <sherd/triangle_mesh.h>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Volume, centroid and second moment of the solid that a closed surface bounds (divergence theorem), unit
/// density.
Moments solidMoments(const TriangleMesh& mesh);

/// The volume alone, m^3; exact up to rounding if `origin` is near.
double enclosedVolume(const TriangleMesh& mesh, const Vec3& origin);

}  // namespace sherd
