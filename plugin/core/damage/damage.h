#pragma once

#include <sherd/material.h>
#include <sherd/stress_field.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Two-state damage of every particle (paper, section 6.1 with C_d infinite).
struct Damage {
    std::vector<char> damaged;  ///< #particles, 1 where the strength is exceeded
    std::vector<double>
        overstress;  ///< #particles, largest tension, or compression, over the strength against it
    double largest_stress_pa = 0;  ///< over all particles
    int count = 0;                 ///< damaged particles
};

/// Tensile strength of every particle, Pa: scattered about the material's by `seed` and index, normally or
/// after Weibull with its size effect, never below a third of the mean for the particle's volume; times
/// `field` at its place, if there is one. Throws std::invalid_argument where the field is not positive.
std::vector<double> particleStrengths(const Material& material, const std::vector<Particle>& particles,
                                      std::uint64_t seed,
                                      const std::function<double(const Vec3&)>& field = {});

/// The smallest fraction of the material's strength that particleStrengths can give to particles of up to a
/// volume.
double weakestStrengthFraction(const Material& material, double largest_volume_m3);

/// Marks the particles whose largest principal stress, at the particle or at a surface point of its
/// sub-domain (where brittle cracks start), exceeds its strength, or whose largest compression exceeds
/// `compressive_over_tensile` times that. `scale` multiplies the stress.
/// Particles that are `damaged` already (#particles, or empty) stay so.
Damage damagedParticles(const StressField& stress, double scale, const Discretisation& solid,
                        const std::vector<double>& strengths, double compressive_over_tensile,
                        const std::vector<char>& damaged = {});

}  // namespace sherd
