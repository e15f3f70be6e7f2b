// What the scenes promise to whoever runs them.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "geometry/piece_checks.h"
#include "stage.h"

namespace {

using namespace demo;
using namespace demo_tests;

Scene uprightCup(double height) {
    Scene scene = named("coffee_cup");
    scene.bodies[0].turn_deg = Vec3::Zero();
    scene.bodies[0].position.z() = height;
    return scene;
}

/// Every piece is a closed, oriented surface without self-intersection, and together they are the whole.
void expectSoundPieces(Stage& stage) {
    double volume = 0, mass = 0;
    int checked = 0;
    for (const btRigidBody* body : stage.world->fracture().bodies()) {
        const sherd::BreakableAsset* piece = stage.world->fracture().asset(body);
        EXPECT_EQ(sherd::fragment_support::faultOf(piece->surface()), "");
        volume += piece->volume();
        mass += piece->mass();
        ++checked;
    }
    EXPECT_NEAR(volume / stage.assets[0].volume(), 1, 1e-9);
    EXPECT_NEAR(mass / stage.assets[0].mass(), 1, 1e-9);
    for (const auto& event : stage.events) EXPECT_LT(event.momentum_error_rel, 1e-5);
    std::cout << checked << " pieces checked\n";
}

class EveryScene : public testing::TestWithParam<const char*> {};

TEST_P(EveryScene, BreaksIntoSoundPieces) {
    Stage stage(named(GetParam()));
    while (stage.bodies() < 4 && stage.seconds < 1) stage.run(0.05);
    stage.run(0.1);
    EXPECT_GE(stage.bodies(), 4u);
    expectSoundPieces(stage);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene,
                         testing::Values("coffee_cup", "coffee_plate", "glass_wall", "plane", "plaster_wall",
                                         "wood_wall"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(CoffeeCup, StandsForTenSecondsWithoutASolve) {
    Stage stage(uprightCup(0));
    stage.run(10);
    EXPECT_EQ(stage.world->fracture().counts().solved, 0);
    EXPECT_EQ(stage.bodies(), 1u);
}

TEST(CoffeeCup, DroppedFromTwoCentimetresHolds) {
    Stage stage(uprightCup(0.02));
    stage.run(1);
    EXPECT_EQ(stage.bodies(), 1u);
    EXPECT_GT(stage.world->fracture().counts().seen, 0);
}

TEST(PlasterWall, HasAsManyParticlesAsThePapers) {
    EXPECT_EQ(Stage(named("plaster_wall")).assets[0].particleCount(), 968);
}

TEST(PlasterWall, BallGoesOnThroughAWallWithoutStrength) {
    Scene scene = named("plaster_wall");
    scene.bodies[0].material.tensile_strength_pa = 1;
    const double before = scene.balls[0].velocity.head<2>().norm();
    Stage stage(scene);
    stage.run(0.15);
    const Vec3 from = stage.world->states().back().placed.translation();
    stage.run(0.05);
    const Vec3 travelled = stage.world->states().back().placed.translation() - from;
    const double kept = travelled.dot(scene.balls[0].velocity.normalized()) / 0.05 / before;
    std::cout << "the ball keeps " << 100 * kept << " % of its speed\n";
    EXPECT_GT(kept, 0.6);
}

}  // namespace
