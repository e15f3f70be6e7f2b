#pragma once

#include "core/sampling/cut_cells.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Which sub-domain each integration cell is part of: the connected parts of the solid in each particle cell,
/// those that fill less than `smallest_fill` merged into what they hang on. Numbered in ascending (z, y, x)
/// of the particle cell.
struct SubDomains {
    std::vector<int> of_cell;  ///< #cells
    int count = 0;
};

SubDomains findSubDomains(const SamplingGrid& grid, const CutCells& cells, double smallest_fill);

/// One particle at the centroid of each sub-domain, with volume and spacing.
std::vector<Particle> placeParticles(const SamplingGrid& grid, const CutCells& cells,
                                     const SubDomains& domains);

/// Per sub-domain, which others share a face with it, ascending: neighbours through the solid.
std::vector<std::vector<int>> neighboursThroughSolid(const CutCells& cells, const SubDomains& domains);

}  // namespace sherd
