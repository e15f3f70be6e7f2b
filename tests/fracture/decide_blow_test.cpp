#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include <stdexcept>

#include "fracture/decided.h"
#include "fracture/default_fracture.h"
#include "fracture/struck_plate.h"

namespace {

using namespace sherd;
using namespace sherd::fracture_tests;

std::shared_ptr<const BreakableSolid> plate() {
    return plateAsset().solid();
}

const Blow weak = blowInTheMiddle(0.05, 0.001), hard = blowInTheMiddle(1, 10);

FractureSettings checking(const BreakableSolid& solid) {
    FractureSettings fracture = solid.settings().fracture;
    fracture.check_with_full_solve = true;
    return fracture;
}

TEST(DecideBlow, TheGateDecidesWeakBlowsAndSolvesNothing) {
    const auto solid = plate();
    const BlowOutcome out = decided(*solid, weak, solid->settings().fracture);
    EXPECT_EQ(out.level, Level::gate);
    EXPECT_EQ(out.outcome, Outcome::held);
    EXPECT_DOUBLE_EQ(out.impulse_n_s, 0.05 * 0.001);
    EXPECT_FALSE(solid->hasSolver());
    EXPECT_FALSE(out.full_solve_outcome);
    EXPECT_GT(out.ms.gate, 0);
    EXPECT_EQ(out.ms.total(), out.ms.gate);
}

TEST(DecideBlow, AFullSolveDecidesTheOthers) {
    const auto solid = plate();
    for (const bool check : {false, true}) {
        const BlowOutcome out = decided(*solid, hard, check ? checking(*solid) : solid->settings().fracture);
        EXPECT_EQ(out.level, Level::full);
        EXPECT_EQ(out.outcome, Outcome::broke) << out.message;
        EXPECT_EQ(out.largest_stress_pa, strike(*solid, hard, 1).largest_stress_pa);
        EXPECT_FALSE(out.full_solve_outcome) << "it would say the same";
        EXPECT_GT(out.ms.gate, 0);
    }
}

/// Bullet's solver leaves no impulse where something else stopped the partner a little later.
TEST(DecideBlow, ABlowOfNoImpulseHasThatOfItsPulse) {
    const auto solid = plate();
    constexpr double ball_kg = 1, speed_m_s = 10;
    Blow blow = blowInTheMiddle(ball_kg, speed_m_s);
    blow.contacts[0].impulse = Vec3::Zero();
    blow.contacts[0].touched_s = 0.001;
    const BlowOutcome out = decided(*solid, blow, solid->settings().fracture);
    EXPECT_EQ(out.outcome, Outcome::broke) << out.message;
    // A pulse stops what meets and throws it back. Struck near its centre, the plate hardly turns.
    const double stopped_kg = 1 / (1 / ball_kg + 1 / solid->mass());
    EXPECT_NEAR(out.impulse_n_s, 2 * stopped_kg * speed_m_s, 0.02 * ball_kg * speed_m_s);
}

TEST(DecideBlow, ACheckSaysWhatAFullSolveFindsAndDecidesNothing) {
    const auto solid = plate();
    const BlowOutcome out = decided(*solid, weak, checking(*solid));
    EXPECT_EQ(out.level, Level::gate);
    EXPECT_EQ(out.outcome, Outcome::held);
    EXPECT_EQ(out.largest_stress_pa, 0);
    ASSERT_TRUE(out.full_solve_outcome);
    EXPECT_EQ(*out.full_solve_outcome, Outcome::held);
    EXPECT_GT(out.full_solve_largest_stress_pa, 0);
    EXPECT_EQ(out.full_solve_largest_stress_pa, strike(*solid, weak, 1).largest_stress_pa);
    EXPECT_GT(out.ms.check, 0);
    EXPECT_EQ(out.ms.total(), out.ms.gate + out.ms.check) << "the stages of the check are its own";
}

TEST(DecideBlow, ACheckThatFailsSaysWhy) {
    Settings settings;
    settings.strength.field = [](const Vec3&) -> double { throw std::runtime_error("no field today"); };
    const auto solid = plateAsset(Material::plaster(), settings).solid();
    const BlowOutcome out = decided(*solid, weak, checking(*solid));
    EXPECT_EQ(out.level, Level::gate);
    EXPECT_EQ(out.outcome, Outcome::held);
    EXPECT_EQ(out.full_solve_outcome, Outcome::failed);
    EXPECT_EQ(out.message.find("The full solve says: "), 0u) << out.message;
    EXPECT_NE(out.message.find("no field today"), std::string::npos) << out.message;
}

TEST(DecideBlow, ACheckShowsADecisionThatWasWrong) {
    const auto solid = plate();
    BlowFigures decided;
    decided.level = Level::reduced;
    checkWithFullSolve(*solid, hard, solid->settings().fracture, 1, decided);
    EXPECT_EQ(decided.full_solve_outcome, Outcome::broke);
    EXPECT_EQ(decided.outcome, Outcome::held);
    EXPECT_EQ(decided.level, Level::reduced);
    EXPECT_TRUE(decided.message.empty());
}

}  // namespace
