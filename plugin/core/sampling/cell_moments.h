#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include "core/sampling/cell_parts.h"
#include "core/sampling/moment_rule.h"
#include "core/sampling/sampling_grid.h"
#include "core/sampling/solid_voxels.h"

namespace sherd {

/// Groups the solid's voxels into connected parts of grid cells and integrates all monomials up to `order` of
/// each coordinate over every part, by `rule`.
CellParts measureCellParts(const TriangleMesh& surface, const SamplingGrid& grid, const CutSurface& cut,
                           const SolidVoxels& solid, int order, MomentRule rule);

/// The part of a solid inside a box of cells of a coarser grid, measured anew on cells of half the edge. The
/// box is given by its lowest cell and the one behind its highest; it may reach beyond the coarse grid.
Result<CellParts> refineCellParts(const TriangleMesh& surface, const CellParts& coarse,
                                  const Eigen::Vector3i& lower, const Eigen::Vector3i& upper);

}  // namespace sherd
