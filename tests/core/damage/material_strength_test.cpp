#include "core/damage/material_strength.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

namespace {

using namespace sherd;

constexpr double length = 0.01;

MaterialStrength strengthOf(const Material& material, std::uint64_t seed = 7) {
    StrengthSettings settings;
    settings.seed = seed;
    return {material, length, settings};
}

/// At random places in many cells of the lattice.
std::vector<double> valuesOf(const MaterialStrength& strength, int count) {
    std::mt19937_64 random(3);
    const auto anywhere = [&] { return 50 * length * (static_cast<double>(random() >> 11) * 0x1p-52 - 1); };
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(strength.at({anywhere(), anywhere(), anywhere()}));
    return values;
}

double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (double value : values) sum += value / values.size();
    return sum;
}

double variationOf(const std::vector<double>& values) {
    const double mean = meanOf(values);
    double square = 0;
    for (double value : values) square += (value / mean - 1) * (value / mean - 1) / values.size();
    return std::sqrt(square);
}

Material weibull(double modulus) {
    Material material;
    material.tensile_strength_pa = 4e7;
    material.weibull_modulus = modulus;
    material.weibull_volume_m3 = 1e-6;
    return material;
}

TEST(MaterialStrength, HasTheMeanAndScatterOfTheMaterial) {
    Material material;
    material.tensile_strength_pa = 4e7;
    material.strength_scatter = 0.1;
    const MaterialStrength strength = strengthOf(material);
    const std::vector<double> values = valuesOf(strength, 50000);
    EXPECT_NEAR(meanOf(values) / 4e7, 1, 0.003);
    EXPECT_NEAR(variationOf(values), 0.1, 0.003);
    EXPECT_GE(*std::min_element(values.begin(), values.end()), strength.least());
    EXPECT_EQ(values, valuesOf(strengthOf(material), 50000));
    EXPECT_NE(values, valuesOf(strengthOf(material, 8), 50000));
    material.strength_scatter = 0;
    EXPECT_EQ(strengthOf(material).at({0.3, 0.2, 0.1}), 4e7);
}

// A step of a hundredth of the length changes the strength by little, also from cell to cell, and the values
// of points that are further apart than two cells have nothing to do with each other.
TEST(MaterialStrength, IsContinuousAndScattersOverItsLength) {
    const MaterialStrength strength = strengthOf(Material::glass());
    const double deviation = Material::glass().strength_scatter * 50e6;
    double covariance = 0, former = strength.at({0, 0.003, 0.004});
    constexpr int steps = 40000;
    for (int i = 1; i < steps; ++i) {
        const Vec3 x(0.01 * length * i, 0.003, 0.004);
        const double here = strength.at(x);
        ASSERT_LT(std::abs(here - former), 0.15 * deviation) << i;
        const double far = strength.at(x + Vec3(2 * length, 0, 0));
        covariance += (here / 50e6 - 1) * (far / 50e6 - 1) / steps;
        former = here;
    }
    EXPECT_LT(std::abs(covariance), 0.15 * std::pow(Material::glass().strength_scatter, 2));
}

// Weibull: coefficient of variation sqrt(Gamma(1 + 2/m) / Gamma(1 + 1/m)^2 - 1).
TEST(MaterialStrength, ScattersAfterWeibull) {
    for (const double m : {5.0, 8.0, 20.0}) {
        const MaterialStrength strength = strengthOf(weibull(m));
        const std::vector<double> values = valuesOf(strength, 50000);
        EXPECT_NEAR(variationOf(values),
                    std::sqrt(std::tgamma(1 + 2 / m) / std::pow(std::tgamma(1 + 1 / m), 2) - 1), 0.004);
        EXPECT_GE(*std::min_element(values.begin(), values.end()), strength.least() * (1 - 1e-12));
    }
}

// The weakest point of a cube of volume V has the mean strength sigma_0 (V_0 / V)^(1/m), whatever the
// distance between the points that are looked at, as long as it is well below the length.
TEST(MaterialStrength, FallsAfterWeibullWithSize) {
    for (const double m : {8.0, 16.0})
        for (const int cells : {2, 4})
            for (const int steps : {4, 6}) {
                const double edge = cells * length, step = length / steps;
                std::vector<double> weakest;
                for (int body = 0; body < 1600 / (cells * cells * cells); ++body) {
                    const MaterialStrength strength = strengthOf(weibull(m), body);
                    double least = 1e30;
                    for (double x = step / 2; x < edge; x += step)
                        for (double y = step / 2; y < edge; y += step)
                            for (double z = step / 2; z < edge; z += step)
                                least = std::min(least, strength.at({x, y, z}));
                    weakest.push_back(least);
                }
                const double expected = 4e7 * std::pow(1e-6 / std::pow(edge, 3), 1 / m);
                EXPECT_NEAR(meanOf(weakest) / expected, 1, 0.06) << m << ' ' << cells << ' ' << steps;
            }
}

TEST(MaterialStrength, AStrengthFieldScalesItAtEachPlace) {
    const MaterialStrength plain = strengthOf(Material::glass(), 5);
    StrengthSettings settings;
    settings.seed = 5;
    settings.field = [](const Vec3& x) { return x.x() + 0.5; };
    const MaterialStrength painted(Material::glass(), length, settings);
    for (int i = 0; i < 3; ++i)
        EXPECT_DOUBLE_EQ(painted.at(Vec3(i, 0, 0)), plain.at(Vec3(i, 0, 0)) * (i + 0.5));
    const auto sentence = [&](double minimum) -> std::string {
        settings.field = [](const Vec3& x) { return 1 - x.x(); };
        settings.field_minimum = minimum;
        const MaterialStrength falling(Material::glass(), length, settings);
        try {
            for (int i = 0; i < 2; ++i) static_cast<void>(falling.at(Vec3(i, 0, 0)));
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

// A length of the body's own, that preview resolves.
TEST(ScatterLength, IsThatOfWallsAndOfPartsOfCompactBodies) {
    EXPECT_NEAR(scatterLength(0.09, 0.09), 0.09, 1e-12);
    EXPECT_NEAR(scatterLength(0.008, 0.2), 0.2 / std::cbrt(80), 1e-12);
    EXPECT_NEAR(scatterLength(0.004, 0.004), 1 / std::sqrt(1500), 1e-12);
    EXPECT_GT(scatterLength(0.004, 0), 0);
}

}  // namespace
