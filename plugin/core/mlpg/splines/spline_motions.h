#pragma once

#include "core/mlpg/rigid_motions.h"
#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// The rigid motions of a solid in terms of the coefficients of its splines.
RigidMotions splineMotions(const CellParts& solid, const SplineSpace& space);

}  // namespace sherd
