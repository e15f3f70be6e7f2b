#pragma once

#include "core/sampling/cut_cells.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// The sub-domains of the particles: the parts of the solid that are connected inside one particle cell,
/// small ones merged into a neighbour. Numbered in the order of their particle cells, x fastest, z slowest.
struct SubDomains {
    std::vector<int> of_cell;  ///< #cells
    int count = 0;
};

/// Parts that fill less than `smallest_fill` of a particle cell are merged as `mergeSmall` says.
SubDomains findSubDomains(const SamplingGrid& grid, const CutCells& cells, double smallest_fill);

/// One particle at the centroid of each sub-domain, with volume and spacing.
std::vector<Particle> placeParticles(const SamplingGrid& grid, const CutCells& cells,
                                     const SubDomains& domains);

/// Per sub-domain the others that share a face with it, ascending: its neighbours through the solid.
std::vector<std::vector<int>> neighboursThroughSolid(const CutCells& cells, const SubDomains& domains);

}  // namespace sherd
