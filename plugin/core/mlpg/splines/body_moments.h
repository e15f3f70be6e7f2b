#pragma once

#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// Integrals of phi_a (1, x - origin) of every raw function, 4 x raw_count, m^3 and m^4; `origins` per part.
Eigen::Matrix4Xd splineBodyMoments(const CellParts& solid, const SplineSpace& space,
                                   const std::vector<Vec3>& origins);

}  // namespace sherd
