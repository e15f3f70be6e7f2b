#include "core/damage/material_strength.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "core/numerics/split_mix.h"

namespace sherd {

namespace {

constexpr double widest = 3;         // standard deviations; a normal tail would give strengths below zero
constexpr double weakest = 1.0 / 3;  // of the mean strength: bodies that were handled hold no worse flaws
/// Minima over cubes of 2 to 8 lattice cells fall with the size as those of so many independent points in
/// each cell do, whatever the Weibull modulus (the test of the size effect measures it).
constexpr double points_per_cell = 6;

/// Close to normal, and the same bits with every standard library: the sum of 12 uniform numbers, less 6.
double nearlyNormal(std::uint64_t seed, const std::array<std::int64_t, 3>& node) {
    std::uint64_t state = splitMix64(seed);
    for (const std::int64_t index : node) state = splitMix64(state ^ static_cast<std::uint64_t>(index));
    constexpr int bits = 16, of_number = 64 / bits, numbers = 12 / of_number;
    std::uint64_t sum = 0;
    for (int i = 0; i < numbers; ++i) {
        std::uint64_t random = splitMix64(state + golden_step * i);
        for (int k = 0; k < of_number; ++k, random >>= bits) sum += random & ((1U << bits) - 1);
    }
    constexpr double expected = 6 * ((1U << bits) - 1);  // so that the mean is 0
    return (static_cast<double>(sum) - expected) / (1U << bits);
}

/// A Gaussian random field of mean 0 and variance 1 everywhere, continuous and with a continuous slope; x in
/// lattice cells.
double gaussianField(std::uint64_t seed, const Vec3& x) {
    std::array<std::int64_t, 3> low;
    double weights[3][2];
    for (int d = 0; d < 3; ++d) {
        const double cell = std::floor(x[d]), t = x[d] - cell;
        low[d] = static_cast<std::int64_t>(cell);
        weights[d][1] = t * t * (3 - 2 * t);
        weights[d][0] = 1 - weights[d][1];
    }
    double sum = 0, variance = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const double weight = weights[0][i] * weights[1][j] * weights[2][k];
        sum += weight * nearlyNormal(seed, {low[0] + i, low[1] + j, low[2] + k});
        variance += weight * weight;
    }
    return sum / std::sqrt(variance);
}

/// -ln of the probability that a normal number is above z.
double cumulativeHazard(double z) {
    const double above = 0.5 * std::erfc(z * std::sqrt(0.5));
    return z > 0 ? -std::log(above) : -std::log1p(-0.5 * std::erfc(-z * std::sqrt(0.5)));
}

/// Mean strength of a volume over the material's (Weibull 1939).
double sizeEffect(const Material& material, double volume_m3) {
    if (material.weibull_modulus == 0) return 1;
    return std::pow(material.weibull_volume_m3 / volume_m3, 1 / material.weibull_modulus);
}

/// Throws a sentence about a value of the strength field at x that cannot be.
void checkFactor(double factor, const Vec3& x, double minimum) {
    if (factor > 0 && factor >= minimum && std::isfinite(factor)) return;
    std::ostringstream sentence;
    sentence << "the strength field is " << factor << " at (" << x.transpose() << ") m; ";
    if (factor > 0 && factor < minimum)
        sentence << "field_minimum says that it is nowhere below " << minimum;
    else
        sentence << "it has to be above 0 and finite everywhere in the body";
    throw std::invalid_argument(sentence.str());
}

}  // namespace

MaterialStrength::MaterialStrength(const Material& material, double scatter_length_m,
                                   const StrengthSettings& settings)
    : settings_(settings),
      mean_pa_(material.tensile_strength_pa *
               sizeEffect(material, std::pow(scatter_length_m, 3) / points_per_cell)),
      scatter_(material.strength_scatter),
      weibull_modulus_(material.weibull_modulus),
      weibull_scale_(weibull_modulus_ > 0 ? 1 / std::tgamma(1 + 1 / weibull_modulus_) : 1),
      scatter_length_m_(scatter_length_m) {}

/// Over the mean.
double MaterialStrength::scattered(const Vec3& x) const {
    if (weibull_modulus_ == 0 && scatter_ == 0) return 1;
    const double z = gaussianField(settings_.seed, x / scatter_length_m_);
    if (weibull_modulus_ == 0) return std::max(weakest, 1 + scatter_ * std::clamp(z, -widest, widest));
    return std::max(weakest, weibull_scale_ * std::pow(cumulativeHazard(z), 1 / weibull_modulus_));
}

double MaterialStrength::at(const Vec3& x) const {
    const double strength = mean_pa_ * scattered(x);
    if (!settings_.field) return strength;
    const double factor = settings_.field(x);
    checkFactor(factor, x, settings_.field_minimum);
    return strength * factor;
}

double MaterialStrength::least() const {
    const double least = weibull_modulus_ > 0 ? weakest : std::max(weakest, 1 - widest * scatter_);
    return mean_pa_ * least * (settings_.field ? settings_.field_minimum : 1);
}

// Preview has two particles across a wall and 80 in a body, and is content with the third where a wall of the
// first is more than its factor may hold.
double scatterLength(double volume_m3, double wall_thickness_m) {
    constexpr double in_compact_body = 80, in_sheet = 1500;  // cells of the lattice
    const double compact = std::cbrt(volume_m3 / in_compact_body);
    if (!(wall_thickness_m > 0)) return compact;
    const double sheet = std::sqrt(volume_m3 / wall_thickness_m / in_sheet);
    return std::max(std::min(wall_thickness_m, compact), sheet);
}

std::vector<double> strengthsAtSamples(const MaterialStrength& strength, const Discretisation& sampling) {
    std::vector<double> strengths;
    strengths.reserve(sampling.particles.size() + sampling.surface_points.size());
    for (const Particle& particle : sampling.particles) strengths.push_back(strength.at(particle.position));
    for (const SurfacePoint& point : sampling.surface_points)
        strengths.push_back(strength.at(point.position));
    return strengths;
}

}  // namespace sherd
