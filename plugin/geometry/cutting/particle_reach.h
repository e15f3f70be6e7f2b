#pragma once

#include <cstddef>
#include <vector>

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

/// The kernels that reach each particle. Fragments do not change them.
struct ParticleReach {
    struct Contribution {
        int particle;
        double kernel;
    };
    std::vector<std::size_t> first = {0};  ///< #particles + 1, offsets into `all`
    std::vector<Contribution> all;
};

ParticleReach reachOfParticles(const Discretisation& solid);

}  // namespace sherd
