#include "core/damage/damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/stress/principal_stresses.h"

namespace {

using namespace sherd;

/// Damage of particles of one tensile strength, in a material whose compressive strength is a multiple of its
/// tensile one, or that is never crushed.
Damage damageOf(const StressField& stress, double scale, const Discretisation& sampling, double strength_pa,
                double compressive_over_tensile, const std::vector<char>& damaged = {},
                const char* criterion = "largest_principal_stress") {
    Material material;
    if (compressive_over_tensile > 0)
        material.compressive_strength_pa = compressive_over_tensile * material.tensile_strength_pa;
    const std::vector<double> strengths(sampling.particles.size() + sampling.surface_points.size(),
                                        strength_pa);
    return damagedParticles(stress, scale, sampling, {*failureCriterion(criterion), material, strengths},
                            damaged);
}

constexpr double never_crushed = 0;

TEST(Damage, TensionAtTheParticleOrItsSurfaceBreaksCompressionOnlyWhereItCrushes) {
    Discretisation sampling;
    sampling.particles.resize(4);
    sampling.cells.resize(4);
    for (int i = 0; i < 4; ++i) sampling.cells[i].particle = i;
    sampling.surface_points.resize(1);
    sampling.surface_points[0].cell = 3;
    StressField stress;
    stress.particles.assign(4, SymmetricTensor::Zero());
    stress.surface.assign(1, SymmetricTensor::Zero());
    stress.particles[0] << 0, 0, 3, 0, 0, 0;
    stress.particles[1] << -9, -9, -9, 0, 0, 0;
    stress.particles[2] << 0, 0, 0, 2.5, 0, 0;  // shear: tension at 45 degrees
    stress.surface[0] << 0, 5, 0, 0, 0, 0;
    const Damage damage = damageOf(stress, 2, sampling, 4.5, never_crushed);
    EXPECT_EQ(damage.damaged, (std::vector<char>{1, 0, 1, 1}));
    EXPECT_EQ(damage.count, 3);
    EXPECT_NEAR(damage.largest_stress_pa, 10, 1e-12);
    EXPECT_NEAR(damage.overstress[0], 6 / 4.5, 1e-12);
    EXPECT_EQ(damage.stress[0], 2 * stress.particles[0]);
    EXPECT_EQ(damage.stress[3], 2 * stress.surface[0]) << "of the point that is nearest to failure";
    // 2 x 9 of compression against 3 x 4.5.
    const Damage crushed = damageOf(stress, 2, sampling, 4.5, 3);
    EXPECT_EQ(crushed.damaged, (std::vector<char>{1, 1, 1, 1}));
    EXPECT_NEAR(crushed.overstress[1], 18 / 13.5, 1e-12);
    EXPECT_EQ(damageOf(stress, 2, sampling, 4.5, 4.1).damaged[1], 0);
}

TEST(Damage, IsWhatTheCriterionSays) {
    Discretisation sampling;
    sampling.particles.resize(1);
    StressField stress;
    stress.particles.assign(1, SymmetricTensor::Zero());
    stress.particles[0] << 0.6, 0, -1.8, 0, 0, 0;
    EXPECT_EQ(damageOf(stress, 1, sampling, 1, 3).count, 0);
    const Damage sheared = damageOf(stress, 1, sampling, 1, 3, {}, "mohr_coulomb");
    EXPECT_EQ(sheared.count, 1);
    EXPECT_NEAR(sheared.overstress[0], 1.2, 1e-12);
    EXPECT_NEAR(sheared.largest_stress_pa, 0.6, 1e-12);
}

TEST(Damage, IsThatOfTheWorstPointOfEachParticle) {
    constexpr int particles = 3, points = 600;
    Discretisation sampling;
    sampling.particles.resize(particles);
    sampling.cells.resize(particles);
    sampling.surface_points.resize(points);
    StressField stress;
    stress.particles.assign(particles, SymmetricTensor::Zero());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < particles; ++i) sampling.cells[i].particle = i;
    for (int q = 0; q < points; ++q) {
        sampling.surface_points[q].cell = q % particles;
        SymmetricTensor s = SymmetricTensor::NullaryExpr([&] { return any(random); });
        if (q % 5 == 0) s.tail<3>().setZero();
        if (q % 15 == 0) s.head<3>().setConstant(s[0]);
        stress.surface.push_back(s);
    }
    for (const char* name : {"largest_principal_stress", "mohr_coulomb"}) {
        Material material;
        material.compressive_strength_pa = 3 * material.tensile_strength_pa;
        std::vector<double> worst(particles, 0.0);
        double tension = 0;
        for (int q = 0; q < points; ++q) {
            const PrincipalStresses principal = principalStresses(stress.surface[q]);
            double& own = worst[q % particles];
            own = std::max(own, 1 / 0.7 * failureCriterion(name)->equivalent_stress_pa(principal, material));
            tension = std::max(tension, principal.largest);
        }
        const Damage damage = damageOf(stress, 1, sampling, 0.7, 3, {}, name);
        EXPECT_EQ(damage.overstress, worst) << name;
        EXPECT_EQ(damage.largest_stress_pa, tension) << name;
    }
}

TEST(Damage, TellsTheLargestTensionAlsoWhereCompressionIsNearerToFailure) {
    Discretisation sampling;
    sampling.particles.resize(1);
    sampling.cells.resize(1);
    sampling.cells[0].particle = 0;
    sampling.surface_points.resize(1);
    sampling.surface_points[0].cell = 0;
    StressField stress;
    stress.particles.assign(1, SymmetricTensor::Zero());
    stress.surface.assign(1, SymmetricTensor::Zero());
    stress.particles[0] << -90, 0, 0, 0, 0, 0;
    stress.surface[0] << 2, 0, 0, 0, 0, 0;
    const Damage damage = damageOf(stress, 1, sampling, 1, 3);
    EXPECT_NEAR(damage.overstress[0], 30, 1e-12);
    EXPECT_NEAR(damage.largest_stress_pa, 2, 1e-12);
}

TEST(Damage, WhatIsDamagedStaysSo) {
    Discretisation sampling;
    sampling.particles.resize(2);
    StressField stress;
    stress.particles.assign(2, SymmetricTensor::Zero());
    const Damage damage = damageOf(stress, 1, sampling, 1, never_crushed, {1, 0});
    EXPECT_EQ(damage.damaged, (std::vector<char>{1, 0}));
    EXPECT_EQ(damage.count, 1);
}

}  // namespace
