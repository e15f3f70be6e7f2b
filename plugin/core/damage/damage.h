#pragma once

#include <sherd/material.h>
#include <sherd/stress_field.h>

#include <cstdint>
#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Two-state damage of every particle (paper, section 6.1 with C_d infinite).
struct Damage {
    std::vector<char> damaged;       ///< #particles, 1 where the strength is exceeded
    std::vector<double> overstress;  ///< #particles, largest principal stress over strength
    double largest_stress_pa = 0;    ///< over all particles
    int count = 0;                   ///< damaged particles
};

/// Tensile strength of every particle, Pa: normally scattered about the material's, by `seed` and index,
/// never below a third of it.
std::vector<double> particleStrengths(const Material& material, std::size_t particles, std::uint64_t seed);

/// The smallest fraction of the material's strength that particleStrengths can give.
double weakestStrengthFraction(const Material& material);

/// Marks the particles whose largest principal stress, at the particle or at a surface point of its
/// sub-domain (where brittle cracks start), exceeds its strength. `scale` multiplies the stress.
Damage damagedParticles(const StressField& stress, double scale, const Discretisation& solid,
                        const std::vector<double>& strengths);

}  // namespace sherd
