#pragma once

#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Radius of a particle's kernel, m: wide enough that no bumps of single particles are left.
inline double kernelRadius(const Particle& particle) {
    return 2.0 * particle.spacing;
}

/// The kernel (1 - r^2)^3 of a relative squared distance; 0 from 1 on.
inline double kernel(double r_squared) {
    const double s = 1 - r_squared;
    return s > 0 ? s * s * s : 0;
}

/// #particles, the factor of each particle's kernel in the density of its label: its volume over the cube of
/// the kernel's radius, raised where its own label would not clearly win at its position, so that fragments
/// of one particle survive the smoothing.
std::vector<double> particleWeights(const Discretisation& solid, const FragmentLabels& labels);

}  // namespace sherd
