#pragma once

#include "core/sampling/discretisation.h"

namespace sherd {

/// Particle that owns the integration cell whose centroid is nearest to x: the sub-domain that a point in or
/// on the solid belongs to, or lies beside.
int nearestOwner(const Discretisation& solid, const Vec3& x);

}  // namespace sherd
