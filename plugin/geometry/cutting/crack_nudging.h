#pragma once

#include "geometry/cutting/crack_complex.h"

namespace sherd {

/// Moves the points that a triangle depends on a little along their lattice edges, so that it no longer
/// passes too near to a vertex or an edge of the body's surface; each `attempt` gives other places.
void nudgeTriangle(CrackComplex& complex, const LabelLattice& lattice, int triangle, std::uint64_t seed,
                   int attempt);

}  // namespace sherd
