#include "core/damage/damage.h"

#include <algorithm>
#include <random>

namespace sherd {

namespace {

constexpr double kWidest = 3;  // standard deviations; a normal tail would give strengths below zero

/// Sum of 12 uniform numbers, less 6: close to normal, and the same bits with every standard library.
double nearlyNormal(std::mt19937_64& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random() >> 11) * 0x1p-53;
    return std::clamp(sum, -kWidest, kWidest);
}

double fraction(const Material& material, double deviations) {
    return std::max(1.0 / 3.0, 1 + material.strength_scatter * deviations);
}

}  // namespace

std::vector<double> particleStrengths(const Material& material, std::size_t particles, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<double> strengths(particles);
    for (double& s : strengths) s = material.tensile_strength_pa * fraction(material, nearlyNormal(random));
    return strengths;
}

double weakestStrengthFraction(const Material& material) {
    return fraction(material, -kWidest);
}

Damage damagedParticles(const StressField& stress, double scale, const Discretisation& solid,
                        const std::vector<double>& strengths) {
    const std::size_t n = solid.particles.size();
    std::vector<double> largest(n);
    for (std::size_t i = 0; i < n; ++i) largest[i] = largestPrincipal(stress.particles[i]);
    for (std::size_t q = 0; q < solid.surface_points.size(); ++q) {
        double& s = largest[solid.cells[solid.surface_points[q].cell].particle];
        s = std::max(s, largestPrincipal(stress.surface[q]));
    }
    Damage damage;
    damage.damaged.resize(n);
    damage.overstress.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        damage.overstress[i] = scale * largest[i] / strengths[i];
        damage.damaged[i] = damage.overstress[i] > 1;
        damage.count += damage.damaged[i];
        damage.largest_stress_pa = std::max(damage.largest_stress_pa, scale * largest[i]);
    }
    return damage;
}

}  // namespace sherd
