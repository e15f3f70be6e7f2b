#include "core/damage/damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace sherd;

TEST(Damage, StrengthsHaveTheMeanAndScatterOfTheMaterial) {
    Material material;
    material.tensile_strength_pa = 4e7;
    material.strength_scatter = 0.1;
    const auto strengths = particleStrengths(material, 20000, 7);
    double mean = 0, square = 0;
    for (double s : strengths) mean += s / strengths.size();
    for (double s : strengths) square += (s - mean) * (s - mean) / strengths.size();
    EXPECT_NEAR(mean / 4e7, 1, 0.003);
    EXPECT_NEAR(std::sqrt(square) / 4e6, 1, 0.03);
    EXPECT_GE(*std::min_element(strengths.begin(), strengths.end()), 4e7 * weakestStrengthFraction(material));
    EXPECT_EQ(strengths, particleStrengths(material, 20000, 7));
    EXPECT_NE(strengths, particleStrengths(material, 20000, 8));
}

TEST(Damage, TensionAtTheParticleOrItsSurfaceBreaksCompressionDoesNot) {
    Discretisation solid;
    solid.particles.resize(4);
    solid.cells.resize(4);
    for (int i = 0; i < 4; ++i) solid.cells[i].particle = i;
    solid.surface_points.resize(1);
    solid.surface_points[0].cell = 3;
    StressField stress;
    stress.particles.assign(4, Voigt::Zero());
    stress.surface.assign(1, Voigt::Zero());
    stress.particles[0] << 0, 0, 3, 0, 0, 0;
    stress.particles[1] << -9, -9, -9, 0, 0, 0;
    stress.particles[2] << 0, 0, 0, 2.5, 0, 0;  // shear: tension at 45 degrees
    stress.surface[0] << 0, 5, 0, 0, 0, 0;
    const Damage damage = damagedParticles(stress, 2, solid, std::vector<double>(4, 4.5));
    EXPECT_EQ(damage.damaged, (std::vector<char>{1, 0, 1, 1}));
    EXPECT_EQ(damage.count, 3);
    EXPECT_NEAR(damage.largest_stress_pa, 10, 1e-12);
    EXPECT_NEAR(damage.overstress[0], 6 / 4.5, 1e-12);
}

}  // namespace
