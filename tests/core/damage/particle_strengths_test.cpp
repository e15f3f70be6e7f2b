#include "core/damage/particle_strengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace {

using namespace sherd;

std::vector<Particle> particlesOf(std::size_t count, double volume_m3) {
    Particle particle;
    particle.volume = volume_m3;
    return std::vector<Particle>(count, particle);
}

double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (double value : values) sum += value / values.size();
    return sum;
}

TEST(ParticleStrengths, HaveTheMeanAndScatterOfTheMaterial) {
    Material material;
    material.tensile_strength_pa = 4e7;
    material.strength_scatter = 0.1;
    const auto particles = particlesOf(20000, 1e-6);
    const auto strengths = particleStrengths(material, particles, 7);
    const double mean = meanOf(strengths);
    double square = 0;
    for (double s : strengths) square += (s - mean) * (s - mean) / strengths.size();
    EXPECT_NEAR(mean / 4e7, 1, 0.003);
    EXPECT_NEAR(std::sqrt(square) / 4e6, 1, 0.03);
    EXPECT_GE(*std::min_element(strengths.begin(), strengths.end()),
              4e7 * weakestStrengthFraction(material, 1e-6));
    EXPECT_EQ(strengths, particleStrengths(material, particles, 7));
    EXPECT_NE(strengths, particleStrengths(material, particles, 8));
}

// Weibull: mean sigma_0 (V_0 / V)^(1/m), coefficient of variation sqrt(Gamma(1 + 2/m) / Gamma(1 + 1/m)^2 -
// 1).
TEST(ParticleStrengths, FallAfterWeibullWithSize) {
    Material material;
    material.tensile_strength_pa = 4e7;
    material.weibull_modulus = 8;
    material.weibull_volume_m3 = 1e-6;
    ASSERT_TRUE(material.validate().ok());
    for (const double volume : {1e-8, 1e-6, 1e-3}) {
        const auto strengths = particleStrengths(material, particlesOf(40000, volume), 3);
        const double expected = 4e7 * std::pow(1e-6 / volume, 1 / 8.0), mean = meanOf(strengths);
        EXPECT_NEAR(mean / expected, 1, 0.005);
        double square = 0;
        for (double s : strengths) square += (s / mean - 1) * (s / mean - 1) / strengths.size();
        EXPECT_NEAR(std::sqrt(square), std::sqrt(std::tgamma(1.25) / std::pow(std::tgamma(1.125), 2) - 1),
                    0.004);
        EXPECT_GE(*std::min_element(strengths.begin(), strengths.end()),
                  4e7 * weakestStrengthFraction(material, volume) * (1 - 1e-12));
    }
}

TEST(ParticleStrengths, AStrengthFieldScalesEachAtItsPlace) {
    auto particles = particlesOf(3, 1e-6);
    for (int i = 0; i < 3; ++i) particles[i].position = Vec3(i, 0, 0);
    const auto plain = particleStrengths(Material::glass(), particles, 5);
    const auto painted =
        particleStrengths(Material::glass(), particles, 5, [](const Vec3& x) { return x.x() + 0.5; });
    for (int i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(painted[i], plain[i] * (i + 0.5));
    const auto falling = [](const Vec3& x) { return 1 - x.x(); };
    const auto sentence = [&](double minimum) -> std::string {
        try {
            particleStrengths(Material::glass(), particles, 5, falling, minimum);
            return "";
        } catch (const std::invalid_argument& trouble) {
            return trouble.what();
        }
    };
    EXPECT_EQ(sentence(0),
              "the strength field is 0 at (1 0 0) m; it has to be above 0 and finite everywhere in the body");
    EXPECT_EQ(sentence(1.5),
              "the strength field is 1 at (0 0 0) m; field_minimum says that it is nowhere below 1.5");
}

}  // namespace
