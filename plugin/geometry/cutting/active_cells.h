#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "geometry/cutting/lattice_grid.h"

namespace sherd {

/// The lattice cells that the solid can reach into: those near a triangle of its surface, and those
/// that cannot be reached from outside without crossing such a cell. Only there cracks are of use. Ascending.
std::vector<int> findActiveCells(const TriangleMesh& surface, const LatticeGrid& lattice);

}  // namespace sherd
