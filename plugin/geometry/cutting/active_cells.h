#pragma once

#include "geometry/cutting/label_lattice.h"

namespace sherd {

/// Marks the lattice cells that the solid can touch: those near a triangle of its surface, and those that
/// cannot be reached from outside without crossing such a cell. Cracks through thin air would be thrown away
/// anyway.
std::vector<char> findActiveCells(const TriangleMesh& surface, const LabelLattice& lattice);

}  // namespace sherd
