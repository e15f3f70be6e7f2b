#pragma once

#include <vector>

#include "core/clustering/fragment_labels.h"
#include "geometry/cutting/particle_reach.h"

namespace sherd {

/// #particles, the factor of each particle's kernel in the density of its label: its volume over the cube of
/// the kernel's radius, raised where its own label would not clearly win at its position, so that fragments
/// of one particle survive the smoothing.
std::vector<double> particleWeights(const Discretisation& solid, const ParticleReach& reach,
                                    const FragmentLabels& labels);

}  // namespace sherd
