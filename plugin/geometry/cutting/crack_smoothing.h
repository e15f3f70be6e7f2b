#pragma once

#include "geometry/cutting/crack_complex.h"

namespace sherd {

constexpr int smoothing_steps = 6;

/// Moves every point half the way toward the mean of its neighbours, `steps` times, within its lattice edge
/// or face. Cracks along planes need none of it. Points between two sharp labels (see LabelLattice) move in
/// the first step only.
void smoothCracks(CrackComplex& complex, const LabelLattice& lattice, int steps);

}  // namespace sherd
