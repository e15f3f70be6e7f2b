#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "core/sampling/sampling_grid.h"
#include "core/sampling/surface_pieces.h"

namespace sherd {

/// Integrals over the part of the surface in one voxel, with n_x dA the x component of its outward area.
/// Coordinates from the middle of the voxel's cell, in edges of the cell; powers of x fastest, of z slowest.
struct MomentFlux {
    std::vector<double> volume;  ///< of n_x x^(a+1) / (a+1) y^b z^c
    std::vector<double> face;    ///< of n_x y^b z^c
};

/// The cells of a grid whose moments are wanted: those with a place along x from `first` to below `last`.
/// Each row of voxels along x is summed up from its upper end, so voxels below the range are not needed, and
/// of those above it only the flux through faces.
struct CellColumns {
    int first, last;
};

/// The flux of the surface in every cut voxel, #cut voxels, for powers up to `order` of each coordinate.
/// Exact to rounding for what linear displacements ask of splines of degree `order` / 2; for the products of
/// splines the error falls with the size of the triangles.
std::vector<MomentFlux> momentFlux(const TriangleMesh& surface, const SamplingGrid& grid,
                                   const CutSurface& cut, const CellColumns& columns, int order);

}  // namespace sherd
