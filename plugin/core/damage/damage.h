#pragma once

#include <sherd/material.h>
#include <sherd/stress_field.h>

#include <vector>

#include "core/damage/failure_criterion.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Overstress from which on a place steers where cracks run, and is read for that.
constexpr double near_to_failure = 0.5;

/// Two-state damage of every particle (paper, section 6.1, its damage rate C_d infinite).
struct Damage {
    std::vector<char> damaged;  ///< #particles, 1 where the strength is exceeded
    std::vector<double>
        overstress;  ///< #particles, the largest of the equivalent stress over the tensile strength there
    /// #particles, Pa: the stress that is nearest to failure at each; zero where it was not read.
    std::vector<SymmetricTensor> stress;
    double largest_stress_pa = 0;  ///< largest principal stress at any particle or surface point
    int count = 0;                 ///< damaged particles
};

/// What stress is compared with.
struct Strength {
    const FailureCriterion& criterion;
    const Material& material;
    /// Tensile, where the stress is read, Pa: at the particles, then at the surface points, or at the points
    /// of a DamageReading.
    const std::vector<double>& at_points;
};

/// Marks the particles that fail by the criterion, at the particle or at a surface point of its sub-domain
/// (where brittle cracks start). `scale` multiplies the stress. Particles that are `damaged` already
/// (#particles, or empty) stay so. `points`: those of `stress` that count, in m; each counts for the nearest
/// particle, if it is above half of the weakest strength.
Damage damagedParticles(const StressField& stress, double scale, const Discretisation& sampling,
                        const Strength& strength, const std::vector<char>& damaged = {},
                        const std::vector<Vec3>& points = {});

/// Adds what another moment damages: of each particle the stress that is nearest to failure is kept. `sum`
/// may be empty.
void addDamage(Damage more, Damage& sum);

}  // namespace sherd
