#pragma once

#include "core/sampling/cut_cells.h"
#include "core/sampling/discretisation.h"
#include "core/sampling/surface_pieces.h"

namespace sherd {

/// Quadrature points of the surface with vector weights: in every cell, sum f(x_q) area_q is the integral of
/// f n over the surface for each linear f. A flat side gets one point, at its centroid, a curved one up to
/// four. In the order of the cells.
std::vector<SurfacePoint> surfacePoints(const SamplingGrid& grid, const CutSurface& surface,
                                        const SolidVoxels& solid, const CutCells& cells);

}  // namespace sherd
