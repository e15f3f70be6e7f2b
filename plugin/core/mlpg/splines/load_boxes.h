#pragma once

#include <sherd/types.h>

#include <vector>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// A box of cells of a grid, `upper` exclusive; it may reach beyond the grid.
struct CellBox {
    Eigen::Vector3i lower, upper;
};

/// Boxes around those loads that act on a patch of fewer than four cells across: there stress diverges as the
/// grid gets finer, and the coarse grid only sees the resultant. Patches above `largest_patch` (m) are left
/// alone. At least `margin` cells beyond the loads, and from one plane of every `multiple`-th cell to
/// another.
std::vector<CellBox> boxesAroundLoads(const CellParts& grid, const std::vector<PointForce>& loads,
                                      double largest_patch, double margin, int multiple = 1);

}  // namespace sherd
