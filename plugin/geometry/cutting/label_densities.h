#pragma once

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/label_lattice.h"
#include "geometry/cutting/particle_reach.h"

namespace sherd {

/// Sets the density of each fragment at the nodes of active cells: every particle spreads its volume over a
/// smooth kernel (see particle_weights.h). With a guide field the clusters at a node are then reweighted by
/// the distances of the node from their seeds. Gives each node that a kernel reaches the label that is
/// densest there, the lower of two that are equally dense.
void labelByDensities(const Discretisation& solid, const ParticleReach& reach, const FragmentLabels& labels,
                      LabelLattice& lattice);

}  // namespace sherd
