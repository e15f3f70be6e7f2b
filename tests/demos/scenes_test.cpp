// What the scenes promise to whoever runs them.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "demos/stage.h"

namespace {

using namespace demo;
using namespace demo_tests;

Scene uprightCup(double height) {
    Scene scene = named("coffee_cup");
    scene.bodies[0].turn_deg = Vec3::Zero();
    scene.bodies[0].position.z() = height;
    return scene;
}

TEST(CoffeeCup, StandsForTenSecondsWithoutASolve) {
    Stage stage(uprightCup(0));
    stage.run(10);
    EXPECT_EQ(stage.world->fracture().counts().solved(), 0);
    EXPECT_EQ(stage.bodies(), 1u);
}

TEST(CoffeeCup, DroppedFromTwoCentimetresHolds) {
    Stage stage(uprightCup(0.02));
    stage.run(1);
    EXPECT_EQ(stage.bodies(), 1u);
    EXPECT_GT(stage.world->fracture().counts().seen, 0);
}

TEST(PlasterWall, HasAsManyParticlesAsThePapers) {
    const auto scene = readScene(SHERD_SCENES "/plaster_wall.json", "paper", {});
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(Stage(scene.value()).assets.bodies[0].particleCount(), 968);
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
