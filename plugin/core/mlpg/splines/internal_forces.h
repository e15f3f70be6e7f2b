#pragma once

#include "core/mlpg/splines/spline_supports.h"
#include "core/mlpg/splines/volumetric_projection.h"

namespace sherd {

/// The stiffness between raw functions, without its matrix: forces (3 x raw_count, N) that balance the
/// stresses and springs which raw coefficients `displacement` (m) call up. `projection`: as in
/// splineStiffness.
Eigen::Matrix3Xd splineInternalForces(const CellParts& solid, const SplineSpace& space,
                                      const Elasticity& elasticity, const std::vector<PointSpring>& springs,
                                      const VolumetricProjection* projection,
                                      const Eigen::Matrix3Xd& displacement);

}  // namespace sherd
