#include "pipeline.h"

#include <gtest/gtest.h>

#include <cmath>

#include <sherd/breakable_asset.h>

#include "support/shapes.h"

namespace {

using namespace sherd;

/// A plate of 0.4 x 0.4 x 0.03 m that a ball hits in the middle of its upper face.
std::shared_ptr<const Body> plate(const Material& material, const Settings& settings = {}) {
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.2, -0.2, -0.015), Vec3(0.2, 0.2, 0.015)), material, settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    return asset.value().body();
}

Blow blowInTheMiddle(double mass, double speed) {
    ContactImpulse contact;
    contact.point = Vec3(0.003, 0.002, 0.015);
    contact.normal = -Vec3::UnitZ();
    contact.impulse = -Vec3::UnitZ() * mass * speed;
    contact.approach_m_s = speed;
    contact.effective_mass_kg = mass;
    contact.partner_radius_m = 0.03;
    return {{contact}};
}

TEST(Strike, HardBlowBreaksAPlateAndLosesNothing) {
    const auto body = plate(Material::plaster());
    const BlowOutcome out = strike(*body, blowInTheMiddle(1, 10), 1);
    ASSERT_EQ(out.outcome, BreakEvent::Outcome::broke) << out.message;
    EXPECT_GE(out.fragments.size(), 4u);
    EXPECT_LT(out.volume_error_rel, 1e-9);
    EXPECT_LT(out.mass_error_rel, 1e-9);
    EXPECT_LT(out.residual_rel, 1e-10);
    EXPECT_GT(out.largest_stress_pa, body->material().tensile_strength_pa);
    Vec3 moment = Vec3::Zero();
    for (const Fragment& f : out.fragments) moment += f.body->mass() * f.body->moments().centroid;
    EXPECT_LT((moment / body->mass() - body->moments().centroid).norm(), 1e-9);
}

TEST(Strike, StressGrowsWithTheSpeedOfTheBlow) {
    const auto body = plate(Material::plaster());
    double last = 0;
    for (const double speed : {0.01, 0.1, 1.0}) {
        const BlowOutcome out = strike(*body, blowInTheMiddle(0.1, speed), 1);
        EXPECT_GT(out.largest_stress_pa, 3 * last);
        last = out.largest_stress_pa;
    }
}

TEST(Strike, ABodyThatNothingCanBreakHolds) {
    Material hard = Material::plaster();
    hard.tensile_strength_pa = 1e15;
    const BlowOutcome out = strike(*plate(hard), blowInTheMiddle(10, 30), 1);
    EXPECT_EQ(out.outcome, BreakEvent::Outcome::held);
    EXPECT_TRUE(out.fragments.empty());
    EXPECT_EQ(out.damaged_particles, 0);
}

TEST(Strike, TheBoundNeverHidesABreak) {
    // Wherever the stages end in a break, the bound must have let the blow through.
    Settings settings;
    for (const double spacing : {0.01, 0.02}) {
        settings.sampling.spacing_m = spacing;
        const auto body = plate(Material::plaster(), settings);
        for (double speed = 0.001; speed < 10; speed *= 1.7) {
            const Blow blow = blowInTheMiddle(0.05, speed);
            const bool broke = strike(*body, blow, 1).outcome == BreakEvent::Outcome::broke;
            EXPECT_TRUE(!broke || canBreak(*body, blow)) << speed;
        }
        EXPECT_FALSE(canBreak(*body, blowInTheMiddle(0.05, 0.001)));
        EXPECT_TRUE(canBreak(*body, blowInTheMiddle(1, 10)));
    }
}

TEST(Strike, PressingContactsCannotBreak) {
    const auto body = plate(Material::plaster());
    Blow blow = blowInTheMiddle(1, 10);
    blow.contacts[0].approach_m_s = 0;
    EXPECT_FALSE(canBreak(*body, blow));
}

TEST(Strike, AFurtherBlowAssemblesAndFactorsNothing) {
    const auto body = plate(Material::glass());
    const BlowOutcome first = strike(*body, blowInTheMiddle(0.01, 0.1), 1);
    const BlowOutcome further = strike(*body, blowInTheMiddle(0.01, 0.1), 1);
    EXPECT_GT(first.ms.assemble, 0);
    EXPECT_GT(first.ms.factor, 0);
    EXPECT_EQ(further.ms.assemble, 0);
    EXPECT_EQ(further.ms.factor, 0);
    EXPECT_EQ(further.largest_stress_pa, first.largest_stress_pa);
}

TEST(Strike, SameSeedSameFragmentsOtherSeedOthers) {
    const auto volumes = [](std::uint64_t seed) {
        Settings settings;
        settings.fracture.seed = seed;
        std::vector<double> v;
        for (const Fragment& f : strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), seed).fragments)
            v.push_back(f.body->moments().volume);
        return v;
    };
    EXPECT_EQ(volumes(1), volumes(1));
    EXPECT_NE(volumes(1), volumes(2));
}

TEST(Strike, FragmentsBreakAgain) {
    Settings settings;
    settings.fracture.fragment_count = 4;
    const BlowOutcome out = strike(*plate(Material::plaster(), settings), blowInTheMiddle(1, 10), 1);
    ASSERT_EQ(out.outcome, BreakEvent::Outcome::broke) << out.message;
    const Fragment* largest = &out.fragments.front();
    for (const Fragment& f : out.fragments)
        if (f.body->mass() > largest->body->mass()) largest = &f;
    Blow blow = blowInTheMiddle(1, 20);
    blow.contacts[0].point = largest->body->moments().centroid + Vec3(0, 0, 0.02);
    const BlowOutcome again = strike(*largest->body, blow, 2);
    EXPECT_EQ(again.outcome, BreakEvent::Outcome::broke) << again.message;
    EXPECT_LT(again.volume_error_rel, 1e-9);
}

TEST(Strike, WithoutContactsNothingHappens) {
    const BlowOutcome out = strike(*plate(Material::plaster()), {}, 1);
    EXPECT_EQ(out.outcome, BreakEvent::Outcome::held);
    EXPECT_EQ(out.damaged_particles, 0);
}

}  // namespace
