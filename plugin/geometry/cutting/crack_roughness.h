#pragma once

#include "geometry/cutting/crack_complex.h"

namespace sherd {

/// Moves the points along their lattice edges by up to `amplitude` m, at random, and no further than
/// `clampToEdge` allows. Keeps the normals that the triangles had.
void roughenCracks(CrackComplex& complex, const LabelLattice& lattice, double amplitude, std::uint64_t seed);

}  // namespace sherd
