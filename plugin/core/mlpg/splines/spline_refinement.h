#pragma once

#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// Raw coefficients (3 x raw_count) on a grid with cells half as long of the very same displacement that
/// `coarse_raw` is on the coarse one: spaces of splines on nested grids are nested. `parents`: see
/// parentParts.
Eigen::Matrix3Xd refinedCoefficients(const CellParts& coarse, const SplineSpace& coarse_space,
                                     const Eigen::Matrix3Xd& coarse_raw, const CellParts& fine,
                                     const SplineSpace& fine_space, const std::vector<int>& parents);

/// Per part of the finer grid, the coarse part that holds its centroid, or the nearest; -1 where there is
/// none.
std::vector<int> parentParts(const CellParts& coarse, const CellParts& fine);

}  // namespace sherd
