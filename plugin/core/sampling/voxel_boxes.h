#pragma once

#include <sherd/types.h>

#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// An axis-aligned box in the asset's frame, m.
struct Box {
    Vec3 centre = Vec3::Zero();
    Vec3 half_extents = Vec3::Zero();
};

/// Boxes that stand for the wanted voxels (`wanted`: #voxels), merged greedily along x, then y, then z.
/// Voxels less than half solid are left out, unless all are; the faces then move to where the solid ends
/// (BoxFit).
std::vector<Box> mergedBoxes(const Discretisation& solid, const std::vector<char>& wanted);

/// The same for each of `count` pieces. `owner` (#voxels): the piece that each voxel belongs to, or -1.
std::vector<std::vector<Box>> boxesOfPieces(const Discretisation& solid, const std::vector<int>& owner,
                                            int count);

}  // namespace sherd
