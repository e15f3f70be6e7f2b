#include "core/mlpg/reduced/reduced_model.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/block_product.h"
#include "core/mlpg/reduced/reduced_support.h"

namespace sherd {
namespace {

struct ReducedModelTest : testing::Test {
    static const BothSolutions& wall() {
        static const BothSolutions both = bothSolutions(obliqueWall(), 0.02);
        return both;
    }
};

TEST_F(ReducedModelTest, StressIsThatOfTheFullSolve) {
    std::mt19937 random(1);
    std::vector<double> errors;
    for (int i = 0; i < 30; ++i) {
        const auto loads = randomPush(*wall().solid, 0.02, random);
        const double full = largestTension(stressUnder(wall(), fullSolution(wall(), loads).first, loads));
        const auto response = valueOf(wall().reduced.model.respond(loads));
        const double reduced = largestTension(stressUnder(wall(), response.unknowns.cast<double>(), loads));
        errors.push_back(std::abs(reduced / full - 1));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[15], 0.01);
    EXPECT_LT(errors.back(), 0.06);
}

// The reduced space is a part of the full one, so that it is never softer.
TEST_F(ReducedModelTest, StoresNoMoreThanTheFullSolveAndNearlyAsMuch) {
    std::mt19937 random(2);
    for (int i = 0; i < 30; ++i) {
        const auto loads = randomPush(*wall().solid, 0.02, random);
        const double full = fullSolution(wall(), loads).second;
        const double reduced = valueOf(wall().reduced.model.respond(loads)).strain_energy_j;
        EXPECT_LT(reduced, full * 1.001);
        EXPECT_GT(reduced, full * 0.93);
    }
}

TEST_F(ReducedModelTest, RigidMotionCostsNoEnergyAndModesHaveNone) {
    std::mt19937 random(3);
    const auto loads = randomPush(*wall().solid, 0.02, random);
    const Eigen::VectorXd u = valueOf(wall().reduced.model.respond(loads)).unknowns.cast<double>();
    const double stored = 0.5 * u.dot(blockProduct(wall().stiffness, u));
    EXPECT_NEAR(stored, valueOf(wall().reduced.model.respond(loads)).strain_energy_j, 0.01 * stored);
}

TEST_F(ReducedModelTest, SeveralPushesAtOnceAreTheirSum) {
    std::mt19937 random(4);
    auto loads = randomPush(*wall().solid, 0.02, random);
    for (int i = 0; i < 2; ++i)
        for (const PointForce& load : randomPush(*wall().solid, 0.03, random)) loads.push_back(load);
    const double full = largestTension(stressUnder(wall(), fullSolution(wall(), loads).first, loads));
    const auto response = valueOf(wall().reduced.model.respond(loads));
    EXPECT_NEAR(largestTension(stressUnder(wall(), response.unknowns.cast<double>(), loads)), full,
                0.03 * full);
}

// The full solve holds some unknowns, at the ends of the body, to be rid of rigid motion. They carry no
// force, and hold nothing in the reduced model.
TEST_F(ReducedModelTest, APushWhereTheFullSolveHoldsUnknownsIsLikeAnyOther) {
    ASSERT_FALSE(wall().factor.pinned().empty());
    for (const int unknown : wall().factor.pinned()) {
        const Vec3 place = wall().problem->space->greville_points[unknown / 3];
        const SurfacePoint* nearest = nullptr;
        for (const SurfacePoint& point : wall().solid->surface_points)
            if (!point.normal.isZero() &&
                (!nearest || (point.position - place).norm() < (nearest->position - place).norm()))
                nearest = &point;
        const std::vector<PointForce> loads = {{nearest->position, -nearest->normal}};
        const auto [full, energy] = fullSolution(wall(), loads);
        const auto response = valueOf(wall().reduced.model.respond(loads));
        EXPECT_NEAR(response.strain_energy_j, energy, 0.1 * energy);
        const double peak = largestTension(stressUnder(wall(), full, loads));
        EXPECT_NEAR(largestTension(stressUnder(wall(), response.unknowns.cast<double>(), loads)), peak,
                    0.05 * peak);
    }
}

TEST_F(ReducedModelTest, SameLoadsSameBits) {
    std::mt19937 random(5);
    const auto loads = randomPush(*wall().solid, 0.02, random);
    const BothSolutions again = bothSolutions(obliqueWall(), 0.02);
    EXPECT_EQ(valueOf(wall().reduced.model.respond(loads)).unknowns,
              valueOf(again.reduced.model.respond(loads)).unknowns);
}

TEST_F(ReducedModelTest, ALoadBesideTheBodyIsRefused) {
    const auto response = wall().reduced.model.respond({{Vec3(5, 5, 5), Vec3(1, 0, 0)}});
    ASSERT_FALSE(response.ok());
    EXPECT_NE(response.error().find("outside the body"), std::string::npos);
}

// Squeezed by a wide patch, a ball has little tension, which modes alone have wrong by a tenth of the
// pressure (so in the worst of these, and by 3 % in the median).
TEST(CompactSolid, HasTheStressOfTheFullSolve) {
    const BothSolutions both = bothSolutions(shapes::icosphere(0.15, 3), 0.03);
    std::mt19937 random(6);
    for (int i = 0; i < 12; ++i) {
        const auto loads = randomPush(*both.solid, 0.0375, random);
        const auto [full, energy] = fullSolution(both, loads);
        const auto response = valueOf(both.reduced.model.respond(loads));
        EXPECT_NEAR(response.strain_energy_j, energy, 0.001 * energy);
        const StressField true_stress = stressUnder(both, full, loads),
                          stress = stressUnder(both, response.unknowns.cast<double>(), loads);
        double worst = 0, pressure = 0;
        for (std::size_t q = 0; q < stress.surface.size(); ++q) {
            worst = std::max(worst, (stress.surface[q] - true_stress.surface[q]).norm());
            pressure = std::max(pressure, true_stress.surface[q].norm());
        }
        EXPECT_LT(worst, 0.015 * pressure);
        const double tension = largestTension(true_stress);
        EXPECT_NEAR(largestTension(stress), tension, 0.05 * tension);
    }
}

// It sways on its support: modes know how much, and the stiffness in 16 bits does not.
TEST(CompactSolid, OnASmallSupportStoresNoMoreThanTheFullSolve) {
    std::vector<SupportPoint> foot;
    for (const double x : {-0.01, 0.0, 0.01})
        for (const double y : {-0.01, 0.0, 0.01}) foot.push_back({Vec3(x, y, -0.148), 1e-4});
    const BothSolutions both = bothSolutions(shapes::icosphere(0.15, 3), 0.03, foot);
    std::mt19937 random(7);
    for (int i = 0; i < 12; ++i) {
        const auto loads = randomPush(*both.solid, 0.0375, random);
        const double energy = fullSolution(both, loads).second;
        EXPECT_LT(valueOf(both.reduced.model.respond(loads)).strain_energy_j, 1.001 * energy);
    }
}

TEST_F(ReducedModelTest, PackedStiffnessIsThatOfTheProblem) {
    const PackedStiffness& packed = wall().reduced.model.stiffness();
    const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(wall().stiffness.size(), -1, 1).array().sin();
    const Eigen::VectorXd exact = blockProduct(wall().stiffness, u);
    const Eigen::VectorXd product = packed.times(u.cast<float>()).cast<double>();
    EXPECT_LT((product - exact).norm(), 5e-4 * exact.norm());  // 16 bits
    // Forces that pull neighbours apart are what a few rounds find.
    Eigen::VectorXd rough = u;
    for (Eigen::Index i = 0; i < rough.size(); ++i) rough[i] = i % 6 < 3 ? 1 : -1;
    const Eigen::VectorXd forces = blockProduct(wall().stiffness, rough);
    double before = std::sqrt(rough.dot(forces));
    for (const int rounds : {1, 2, 4, 8}) {
        const Eigen::VectorXd left = rough - packed.solveRoughly(forces.cast<float>(), rounds).cast<double>();
        const double error = std::sqrt(left.dot(blockProduct(wall().stiffness, left)));
        EXPECT_LT(error, 0.7 * before) << rounds;
        before = error;
    }
}

// A window pane, 120 times as long as it is thick: 16 bits a mode would strain it by more than its modes do.
// What is left is what a pane six times as thick has on the same grid (median 6 % free and 0.1 % held).
struct SlenderPane : testing::TestWithParam<bool> {};

TEST_P(SlenderPane, HasTheStressOfTheFullSolve) {
    const bool is_held = GetParam();
    std::vector<SupportPoint> foot;
    if (is_held)
        for (double x = -0.595; x < 0.6; x += 0.01)
            for (double y = -0.004; y < 0.005; y += 0.004) foot.push_back({Vec3(x, y, -0.6), 4e-5});
    const BothSolutions both = bothSolutions(shapes::slab({1.2, 0.01, 1.2}, 12, 1, 12), 0.02, foot);
    EXPECT_GT(both.reduced.model.modes().fineCount(), 0);
    std::mt19937 random(4);
    std::vector<double> errors;
    for (int i = 0; i < 20; ++i) {
        const auto loads = randomPush(*both.solid, 0.02, random);
        const auto [full, energy] = fullSolution(both, loads);
        const auto response = valueOf(both.reduced.model.respond(loads));
        EXPECT_NEAR(response.strain_energy_j, energy, 0.1 * energy);
        const double tension = largestTension(stressUnder(both, full, loads));
        errors.push_back(std::abs(
            largestTension(stressUnder(both, response.unknowns.cast<double>(), loads)) / tension - 1));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[10], 0.05);
    EXPECT_LT(errors.back(), 0.3);
}

INSTANTIATE_TEST_SUITE_P(Supports, SlenderPane, testing::Bool(),
                         [](const auto& info) { return info.param ? "HeldAtItsFoot" : "Free"; });

TEST(ReducedModel, AnchoredBodiesAreHeld) {
    const TriangleMesh rod = shapes::box({0, 0, 0}, {0.5, 0.05, 0.05}, 10, 1, 1);
    std::vector<SupportPoint> clamp;
    for (double y = 0.005; y < 0.05; y += 0.01)
        for (double z = 0.005; z < 0.05; z += 0.01) clamp.push_back({Vec3(0, y, z), 1e-4});
    const BothSolutions both = bothSolutions(rod, 0.0125, clamp);
    const std::vector<PointForce> push = {{Vec3(0.45, 0.025, 0.05), Vec3(0, 0, -1)}};
    const auto [full, energy] = fullSolution(both, push);
    const auto response = valueOf(both.reduced.model.respond(push));
    EXPECT_NEAR(response.strain_energy_j, energy, 0.01 * energy);
    EXPECT_NEAR(largestTension(stressUnder(both, response.unknowns.cast<double>(), push)),
                largestTension(stressUnder(both, full, push)),
                0.02 * largestTension(stressUnder(both, full, push)));
}

}  // namespace
}  // namespace sherd
