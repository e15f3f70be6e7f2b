#pragma once

#include "core/linear_algebra/block_matrix.h"
#include "core/mlpg/splines/spline_supports.h"
#include "core/mlpg/splines/volumetric_projection.h"

namespace sherd {

/// Stiffness of the Galerkin form on a spline space, row (a, i), column (b, j):
///     K_ab = int lambda grad phi_a grad phi_b^T + mu grad phi_b grad phi_a^T + mu (grad phi_a . grad phi_b)
///     I dV
///            + sum over springs k phi_a phi_b I,
/// integrated exactly on every part of a cell by its moments; whole cells share one matrix. `share_of_part`
/// scales what each part adds (#parts, or empty: 1). With a `projection` (that has these shares) the
/// volumetric strain that lambda acts on is the projected one. A block is that of a pair of functions.
BlockMatrix splineStiffness(const CellParts& solid, const SplineSpace& space, const Elasticity& elasticity,
                            const std::vector<PointSpring>& springs,
                            const VolumetricProjection* projection = nullptr,
                            const std::vector<double>& share_of_part = {});

}  // namespace sherd
