#pragma once

#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Which piece each voxel belongs to (#voxels; -1: none): that of its particle's label; where a label came
/// apart in the cut, the piece with the nearest vertex.
std::vector<int> voxelOwners(const Discretisation& sampling, const FragmentLabels& labels,
                             const FragmentSurfaces& surfaces);

}  // namespace sherd
