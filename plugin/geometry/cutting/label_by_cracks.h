#pragma once

#include <cstdint>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/label_lattice.h"

namespace sherd {

/// Gives the nodes of active cells the part of the body on whose side of all cracks they lie, of those parts
/// that have a particle near by, and its label. Where no crack parts two of them, as across a gap, the one
/// with the nearer particle is taken. A node that a crack would pass very near to is jittered anew by `seed`,
/// or the crack would have to bend around it.
void labelByCracks(const Discretisation& solid, const FragmentLabels& labels, std::uint64_t seed,
                   LabelLattice& lattice);

}  // namespace sherd
