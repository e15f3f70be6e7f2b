#include "core/sampling/discretisation.h"

namespace sherd {

double meanParticleVolume(const Discretisation& solid) {
    double mean = 0;
    for (const Particle& p : solid.particles) mean += p.volume / static_cast<double>(solid.particles.size());
    return mean;
}

}  // namespace sherd
