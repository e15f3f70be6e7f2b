#pragma once

#include <cstdint>
#include <memory>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/label_lattice.h"
#include "geometry/cutting/particle_reach.h"

namespace sherd {

/// Gives each node of a lattice over the solid the label that is densest there (see label_densities.h). Nodes
/// that no particle's kernel reaches take the label of the nearest node that has one.
LabelLattice buildLabelLattice(std::shared_ptr<const LatticeLayout> layout, const Discretisation& solid,
                               const ParticleReach& reach, const FragmentLabels& labels, std::uint64_t seed);

}  // namespace sherd
