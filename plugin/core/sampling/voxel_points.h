#pragma once

#include <vector>

#include "core/sampling/solid_voxels.h"

namespace sherd {

/// Adds the moments of a voxel up to `order` of each coordinate, in coordinates of its cell (see
/// CellPart::moments). Eight points of equal weight stand for the solid in it: they have its volume, its
/// centroid and its second moments. All weights are positive, so that no stiffness becomes indefinite.
/// `local`: place of the voxel in its cell of `per_cell` voxels a direction.
void addVoxelPoints(const RawMoments& voxel, const Eigen::Vector3i& local, int per_cell, int order,
                    std::vector<double>& sum);

}  // namespace sherd
