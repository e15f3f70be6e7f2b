#include "core/damage/particle_strengths.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

namespace sherd {

namespace {

constexpr double widest = 3;  // standard deviations; a normal tail would give strengths below zero

/// Sum of 12 uniform numbers, less 6: close to normal, and the same bits with every standard library.
double nearlyNormal(std::mt19937_64& random) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random() >> 11) * 0x1p-53;
    return std::clamp(sum, -widest, widest);
}

constexpr double weakest = 1.0 / 3;  // of the mean strength: bodies that were handled hold no worse flaws

/// Mean strength of a volume over the material's (Weibull 1939).
double sizeEffect(const Material& material, double volume_m3) {
    if (material.weibull_modulus == 0) return 1;
    return std::pow(material.weibull_volume_m3 / volume_m3, 1 / material.weibull_modulus);
}

/// A strength over the mean of its volume.
double scattered(const Material& material, std::mt19937_64& random) {
    if (material.weibull_modulus == 0)
        return std::max(weakest, 1 + material.strength_scatter * nearlyNormal(random));
    const double inverse = 1 / material.weibull_modulus;
    const double uniform = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
    return std::max(weakest, std::pow(-std::log(uniform), inverse) / std::tgamma(1 + inverse));
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

std::vector<double> particleStrengths(const Material& material, const std::vector<Particle>& particles,
                                      std::uint64_t seed, const std::function<double(const Vec3&)>& field,
                                      double field_minimum) {
    std::mt19937_64 random(seed);
    std::vector<double> strengths;
    strengths.reserve(particles.size());
    for (const Particle& particle : particles)
        strengths.push_back(material.tensile_strength_pa * sizeEffect(material, particle.volume) *
                            scattered(material, random));
    for (std::size_t i = 0; field && i < strengths.size(); ++i) {
        const double factor = field(particles[i].position);
        checkFactor(factor, particles[i].position, field_minimum);
        strengths[i] *= factor;
    }
    return strengths;
}

double weakestStrengthFraction(const Material& material, double largest_volume_m3) {
    if (material.weibull_modulus == 0) return std::max(weakest, 1 - widest * material.strength_scatter);
    return weakest * sizeEffect(material, largest_volume_m3);
}

}  // namespace sherd
