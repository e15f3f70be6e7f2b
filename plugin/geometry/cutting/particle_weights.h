#pragma once

#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Radius of a particle's kernel, m: wide enough that the steps between particles are smoothed away.
inline double kernelRadius(const Particle& particle) {
    return 2.0 * particle.spacing;
}

/// The kernel (1 - r^2)^3 of a relative squared distance; 0 from 1 on.
inline double kernel(double r_squared) {
    const double s = 1 - r_squared;
    return s > 0 ? s * s * s : 0;
}

/// #particles, what each adds to the density of its label: the share of its kernel that it fills, raised
/// where its label would not clearly win at its own position.
std::vector<double> particleWeights(const Discretisation& solid, const FragmentLabels& labels);

}  // namespace sherd
