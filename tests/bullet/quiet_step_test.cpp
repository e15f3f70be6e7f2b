#include "bullet/ground/quiet_step.h"

#include "bullet/bodies/breakable.h"
#include "bullet/support.h"
#include "fracture/can_break.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr double dt = 1.0 / 60;

struct QuietStep : testing::Test {
    QuietStep() {
        const BreakableAsset asset = plate(Material::plaster());
        breakable = std::make_unique<Breakable>(asset, fractureSettingsFor(asset, asset.settings().fracture));
        breakable->body = scene.addBox(10, btVector3(0.3f, 0.3f, 0.03f), btVector3(0, 0, 0));
        breakable->least_energy_j = least_j = leastEnergy(*asset.solid(), asset.settings().fracture);
        registry.add(std::move(breakable));
        ball = scene.addBall(1, 0.05, btVector3(0, 0, 1));
    }
    bool quiet() const { return nothingCanBreak(*scene.world, registry, dt); }
    btVector3 speedOf(double energy_j) const { return btVector3(0, 0, btScalar(std::sqrt(2 * energy_j))); }

    TestWorld scene;
    BreakableRegistry registry;
    std::unique_ptr<Breakable> breakable;
    btRigidBody* ball = nullptr;
    double least_j = 0;
};

TEST_F(QuietStep, EnergyOfAllBodiesDecides) {
    ASSERT_GT(least_j, 0);
    EXPECT_TRUE(quiet());
    ball->setLinearVelocity(speedOf(0.2 * least_j));
    EXPECT_TRUE(quiet());
    ball->setLinearVelocity(speedOf(least_j));
    EXPECT_FALSE(quiet());
    ball->setLinearVelocity(btVector3(0, 0, 0));
    ball->setAngularVelocity(btVector3(0, 0, 1e4f));
    EXPECT_FALSE(quiet());
}

TEST_F(QuietStep, WhatTheAppPushesIsNotQuiet) {
    ball->applyCentralForce(speedOf(least_j) / btScalar(dt));
    EXPECT_FALSE(quiet());
    ball->clearForces();
    EXPECT_TRUE(quiet());
    ball->applyTorque(btVector3(1e4f, 0, 0));
    EXPECT_FALSE(quiet());
}

TEST_F(QuietStep, WeightIs) {
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    for (const auto& body : scene.bodies) body->applyGravity();
    EXPECT_TRUE(quiet());
}

TEST_F(QuietStep, KinematicBodiesThatMoveAreNot) {
    ball->setCollisionFlags(ball->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    EXPECT_TRUE(quiet());
    ball->setInterpolationLinearVelocity(btVector3(0, 0, -1));
    EXPECT_FALSE(quiet());
    ball->setCollisionFlags(ball->getCollisionFlags() | btCollisionObject::CF_STATIC_OBJECT);
    EXPECT_FALSE(quiet());
    scene.bodies[0]->forceActivationState(ISLAND_SLEEPING);
    EXPECT_TRUE(anythingAwake(*scene.world));
}

TEST_F(QuietStep, SleepersDoNotCount) {
    ball->setLinearVelocity(speedOf(least_j));
    EXPECT_TRUE(anythingAwake(*scene.world));
    for (const auto& body : scene.bodies) body->forceActivationState(ISLAND_SLEEPING);
    EXPECT_TRUE(quiet());
    EXPECT_FALSE(anythingAwake(*scene.world));
}

}  // namespace
