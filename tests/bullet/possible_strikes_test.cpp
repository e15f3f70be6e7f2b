// Which bodies the contacts of a step may break at most.

#include "bullet/strikes/possible_strikes.h"

#include "bullet/support.h"
#include "core/loads/blow.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr double dt = 1.0 / 60;

struct PossibleStrikesTest : testing::Test {
    /// A box that stands on a floor.
    PossibleStrikesTest() {
        const BreakableAsset asset = plate(Material::plaster());
        auto made = std::make_unique<Breakable>(asset, fractureSettingsFor(asset, asset.settings().fracture));
        mass = asset.mass();
        made->body = body;
        made->least_energy_j = 1;
        breakable = &registry.add(std::move(made));
    }
    bool mayBreak() {
        before.take(*scene.world);
        scene.world->performDiscreteCollisionDetection();
        PossibleStrikes possible(registry, before, dt);
        btDispatcher& dispatcher = *scene.world->getDispatcher();
        for (int i = 0; i < dispatcher.getNumManifolds(); ++i)
            possible.add(*dispatcher.getManifoldByIndexInternal(i));
        return possible.mayBreak(*breakable);
    }
    /// The speed with which a mass has so many joules.
    static btScalar speedOf(double energy_j, double mass_kg) {
        return btScalar(std::sqrt(2 * energy_j / mass_kg));
    }

    TestWorld scene;
    btRigidBody* floor = scene.addFloor();
    btRigidBody* body = scene.addBox(4, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.0999f));
    BreakableRegistry registry;
    StepSnapshot before;
    Breakable* breakable = nullptr;
    double mass = 0;
};

TEST_F(PossibleStrikesTest, WhatRestsIsNotStruck) {
    EXPECT_FALSE(mayBreak());
    body->setLinearVelocity(btVector3(0, 0, -speedOf(0.5, mass)));
    EXPECT_FALSE(mayBreak());
}

TEST_F(PossibleStrikesTest, WhatFallsOnTheFloorBringsAllOfItsEnergy) {
    body->setLinearVelocity(btVector3(0, 0, -speedOf(1.01, mass)));
    EXPECT_TRUE(mayBreak());
}

TEST_F(PossibleStrikesTest, TheSpeedIsThatOfTheFastestPoint) {
    body->setAngularVelocity(btVector3(0, speedOf(1.01, mass) / 0.1f, 0));
    EXPECT_TRUE(mayBreak());
}

TEST_F(PossibleStrikesTest, WhatSlidesAndSpinsAlongTheFloorDoesNotStrikeIt) {
    body->setLinearVelocity(btVector3(speedOf(4, mass), 0, 0));
    body->setAngularVelocity(btVector3(0, 0, speedOf(4, mass) / 0.1f));
    EXPECT_FALSE(mayBreak());
    body->setLinearVelocity(btVector3(speedOf(4, mass), 0, -speedOf(1.01, mass)));
    EXPECT_TRUE(mayBreak());
}

TEST_F(PossibleStrikesTest, WhatStrikesBringsAllOfItsEnergyToABodyThatIsHeld) {
    btRigidBody* ball = scene.addBall(1, 0.05, btVector3(0, 0, 0.2499f), btVector3(0, 0, -speedOf(0.8, 1)));
    EXPECT_FALSE(mayBreak());
    ball->setLinearVelocity(btVector3(0, 0, -speedOf(1.01, 1)));
    EXPECT_TRUE(mayBreak());
}

TEST_F(PossibleStrikesTest, StrikesAddUp) {
    for (const btScalar side : {-0.05f, 0.05f})
        scene.addBall(1, 0.04, btVector3(side, 0, 0.2399f), btVector3(0, 0, -speedOf(0.55, 1)));
    EXPECT_TRUE(mayBreak());
}

TEST_F(PossibleStrikesTest, FallWithinTheStepCounts) {
    const btScalar speed = speedOf(1, mass) - btScalar(9.81 * dt);
    body->setLinearVelocity(btVector3(0, 0, -speed));
    EXPECT_FALSE(mayBreak());
    body->setGravity(btVector3(0, 0, btScalar(-9.81)));
    EXPECT_TRUE(mayBreak());
}

TEST_F(PossibleStrikesTest, OfWhatTheAppMovesNothingIsKnown) {
    btRigidBody* ball = scene.addBall(1, 0.05, btVector3(0, 0, 0.2499f));
    EXPECT_FALSE(mayBreak());
    ball->setCollisionFlags(ball->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    EXPECT_TRUE(mayBreak());
}

TEST_F(PossibleStrikesTest, BodiesOfUnknownPriceAreLookedAt) {
    breakable->least_energy_j = 0;
    EXPECT_TRUE(mayBreak());
}

}  // namespace
