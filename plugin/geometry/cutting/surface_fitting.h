#pragma once

#include <vector>

#include "geometry/cutting/crack_complex.h"
#include "geometry/triangle_tree.h"

namespace sherd {

/// Moves the points between inside and outside along their lattice edges to where those cross the surface,
/// and fixes them. `outside`: the label of nodes outside of the body. Returns the triangle that each point
/// lies on, #points; -1 for points elsewhere.
std::vector<int> fitToSurface(const TriangleTree& surface, const LabelLattice& lattice, int outside,
                              CrackComplex& complex);

}  // namespace sherd
