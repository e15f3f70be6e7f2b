#pragma once

#include "core/sampling/discretisation.h"

namespace sherd {

/// The particle that owns the integration cell whose centroid is nearest to x: that of the sub-domain in
/// which a point of the solid lies, or next to which.
int nearestOwner(const Discretisation& solid, const Vec3& x);

}  // namespace sherd
