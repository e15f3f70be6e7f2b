#pragma once

#include "core/mlpg/rigid_motions.h"
#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// The rigid motions of a solid in terms of the coefficients of its splines.
RigidMotions splineMotions(const CellParts& solid, const SplineSpace& space);
/// The same where the moments of the solid's components are known.
RigidMotions splineMotions(const SplineSpace& space, std::vector<Moments> component_moments);

}  // namespace sherd
