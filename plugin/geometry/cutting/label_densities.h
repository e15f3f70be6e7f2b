#pragma once

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/label_lattice.h"

namespace sherd {

/// The density of each fragment at the nodes of active cells: every particle spreads its volume over a smooth
/// kernel (see particle_weights.h). With a guide field the clusters at a node are then reweighted by the
/// distances of the node from their seeds.
NodeDensities labelDensities(const LabelLattice& lattice, const Discretisation& solid,
                             const FragmentLabels& labels);

}  // namespace sherd
