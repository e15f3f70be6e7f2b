#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include "core/sampling/cell_parts.h"
#include "core/sampling/sampling_grid.h"
#include "core/sampling/solid_voxels.h"

namespace sherd {

/// Groups the solid's voxels to parts of grid cells and integrates all monomials up to `order` a direction
/// over each, by the divergence theorem with the flux along x. Exact to rounding for what linear
/// displacements ask of splines of degree `order` / 2; for their products, the better the smaller the
/// triangles.
CellParts measureCellParts(const TriangleMesh& surface, const SamplingGrid& grid, const CutSurface& cut,
                           const SolidVoxels& solid, int order);

/// The part of a solid inside a box of cells of a coarser grid, sampled anew with cells half as long. `lower`
/// and `upper` (exclusive) may reach beyond the coarse grid.
Result<CellParts> refineCellParts(const TriangleMesh& surface, const CellParts& coarse,
                                  const Eigen::Vector3i& lower, const Eigen::Vector3i& upper);

}  // namespace sherd
