#pragma once

#include "core/sampling/discretisation.h"
#include "core/sampling/solid_voxels.h"

namespace sherd {

/// The integration cells: the solid's voxels, tiny ones merged into neighbours.
struct CutCells {
    std::vector<int> of_voxel;  ///< #solid voxels: the cell it is part of; -1: no volume but by rounding
    std::vector<long long> home_voxel;   ///< #cells: the voxel, on the grid, that others were merged into
    std::vector<Moments> moments;        ///< #cells, m
    std::vector<IntegrationFace> faces;  ///< between different cells, m
};

CutCells mergeCells(const SamplingGrid& grid, const SolidVoxels& solid);

}  // namespace sherd
