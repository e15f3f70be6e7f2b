#pragma once

#include <sherd/triangle_mesh.h>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// A quadrature point of a surface.
struct SurfaceNode {
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 area = Vec3::Zero();      ///< weight times the outward unit normal, m^2
};

/// Points that integrate over the surface whatever is a polynomial on each cell of the grid: the triangles
/// are cut by the grid, and each piece carries a collapsed Gauss rule of `points`^2, exact to a total degree
/// of 2 `points` - 2.
std::vector<SurfaceNode> surfaceQuadrature(const TriangleMesh& surface, const CellParts& grid,
                                           int points = 4);

}  // namespace sherd
