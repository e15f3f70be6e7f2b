#pragma once

#include <sherd/types.h>

#include <vector>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// A box of cells of a grid, `upper` exclusive; it may reach beyond the grid.
struct CellBox {
    Eigen::Vector3i lower, upper;
};

/// How often, how far around the loads, and where the stress is high, the grid is made finer.
struct ResamplingReach {
    int rounds = 0;
    double margin = 0;   ///< beyond the loads, in cells of the coarser grid, at least
    double cells = 4;    ///< across a load, that are fine enough
    double error = 0.1;  ///< of a high stress, over the largest tension, that is small enough
};

/// Boxes around those loads that act on a patch of fewer than `reach.cells` cells across: there stress
/// diverges as the grid gets finer, and the coarse grid only sees the resultant. Patches above
/// `largest_patch` (m) are left alone. At least `reach.margin` cells beyond the loads, and from one plane of
/// every `multiple`-th cell to another.
std::vector<CellBox> boxesAroundLoads(const CellParts& grid, const std::vector<PointForce>& loads,
                                      double largest_patch, const ResamplingReach& reach, int multiple = 1);

}  // namespace sherd
