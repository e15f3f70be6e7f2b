#pragma once

#include "geometry/cutting/crack_complex.h"

namespace sherd {

/// Marching tetrahedra for many materials, on the six tetrahedra of each active lattice cell (Freudenthal's
/// split). All points stay inside the tetrahedron, face or edge that they belong to, so the complex cannot
/// cross itself.
CrackComplex buildCrackComplex(const LabelLattice& lattice);

}  // namespace sherd
