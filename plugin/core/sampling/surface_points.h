#pragma once

#include "core/sampling/cut_cells.h"
#include "core/sampling/discretisation.h"
#include "core/sampling/surface_pieces.h"

namespace sherd {

/// Quadrature points of the surface with vector weights: in every cell, sum f(x_q) area_q is the integral of
/// f n over the surface for each linear f. A flat side takes one point, at its centroid; a curved one up to
/// four. Ordered by cell.
std::vector<SurfacePoint> surfacePoints(const SamplingGrid& grid, const CutSurface& surface,
                                        const SolidVoxels& solid, const CutCells& cells);

}  // namespace sherd
