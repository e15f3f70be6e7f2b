#pragma once

#include <sherd/triangle_mesh.h>

#include "geometry/cutting/label_lattice.h"

namespace sherd {

/// Marks the lattice cells that the solid can reach into: those near a triangle of its surface, and those
/// that cannot be reached from outside without crossing such a cell. Only there cracks are of use.
std::vector<char> findActiveCells(const TriangleMesh& surface, const LabelLattice& lattice);

}  // namespace sherd
