// What fragments take over from the body that broke.

#include <algorithm>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

/// A plate that is about to be broken by a ball.
struct BeforeTheBreak {
    std::vector<btRigidBody*> breakIt() {
        const BlowEvent event = stepUntilBreak(scene, fracture);
        EXPECT_EQ(event.outcome, broke) << event.message;
        EXPECT_GT(event.fragments.size(), 1u);
        return event.fragments;
    }
    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    btRigidBody* body = fracture.add(plate(crumbly(), 0.1), at(0, 0, 0)).value();
    btRigidBody* ball = scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    btRigidBody* other = scene.addBox(1, btVector3(0.1f, 0.1f, 0.1f), btVector3(2, 0, 0));
};

bool collide(TestWorld& scene, const btRigidBody& a, const btRigidBody& b) {
    return scene.dispatcher->needsCollision(&a, &b);
}

void breakAndExpectOtherLeftAlone(BeforeTheBreak& scene) {
    for (const btRigidBody* piece : scene.breakIt()) {
        EXPECT_FALSE(collide(scene.scene, *piece, *scene.other));
        EXPECT_TRUE(collide(scene.scene, *piece, *scene.ball));
    }
}

TEST(Inheritance, PiecesCollideWithNothingThatTheWholeLeftAlone) {
    BeforeTheBreak scene;
    scene.body->setIgnoreCollisionCheck(scene.other, true);
    breakAndExpectOtherLeftAlone(scene);
}

TEST(Inheritance, WhatLeftTheWholeAloneLeavesThePiecesAlone) {
    BeforeTheBreak scene;
    scene.other->setIgnoreCollisionCheck(scene.body, true);
    breakAndExpectOtherLeftAlone(scene);
    EXPECT_EQ(scene.other->getNumObjectsWithoutCollision(), 0)
        << "the whole is gone; another body may get its address";
}

TEST(Inheritance, PiecesCollideWithWhatOnlyAJointKeptFromTheWhole) {
    BeforeTheBreak scene;
    btPoint2PointConstraint joint(*scene.body, *scene.other, btVector3(1, 0, 0), btVector3(-1, 0, 0));
    scene.scene.world->addConstraint(&joint, true);
    ASSERT_FALSE(collide(scene.scene, *scene.body, *scene.other));
    for (const btRigidBody* piece : scene.breakIt()) {
        EXPECT_TRUE(collide(scene.scene, *piece, *scene.other));
        EXPECT_EQ(piece->getNumObjectsWithoutCollision(), 0);
    }
}

TEST(Inheritance, AJointDoesNotHideWhatTheAppSetItself) {
    BeforeTheBreak scene;
    scene.body->setIgnoreCollisionCheck(scene.other, true);
    btPoint2PointConstraint joint(*scene.body, *scene.other, btVector3(1, 0, 0), btVector3(-1, 0, 0));
    scene.scene.world->addConstraint(&joint, true);
    for (const btRigidBody* piece : scene.breakIt()) EXPECT_FALSE(collide(scene.scene, *piece, *scene.other));
}

TEST(Inheritance, RemovedBodyIsForgottenByWhatLeftItAlone) {
    BeforeTheBreak scene;
    scene.other->setIgnoreCollisionCheck(scene.body, true);
    scene.fracture.remove(scene.body);
    EXPECT_EQ(scene.other->getNumObjectsWithoutCollision(), 0);
}

TEST(Inheritance, AnisotropicFrictionWithItsFlags) {
    for (const int mode : {1, 2, 3}) {
        BeforeTheBreak scene;
        scene.body->setAnisotropicFriction(btVector3(1, 0.5f, 0.25f), mode);
        scene.fracture.onFragment([&](FragmentBirth& birth) {
            for (const int flag : {1, 2})
                EXPECT_EQ(birth.body.hasAnisotropicFriction(flag), (mode & flag) != 0);
            // The factors hold along the axes of a body, and those of a piece are its own. Along the whole's:
            const btMatrix3x3 turn = birth.parent.getWorldTransform().getBasis().transpose() *
                                     birth.body.getWorldTransform().getBasis();
            for (int axis = 0; axis < 3; ++axis) {
                const btVector3 along(turn[0][axis], turn[1][axis], turn[2][axis]);
                const btScalar expected = (along * along).dot(btVector3(1, 0.5f, 0.25f));
                EXPECT_NEAR(birth.body.getAnisotropicFriction()[axis], expected, 1e-5);
            }
        });
        EXPECT_FALSE(scene.breakIt().empty());
    }
}

TEST(Inheritance, IsotropicFrictionStaysSo) {
    BeforeTheBreak scene;
    for (const btRigidBody* piece : scene.breakIt()) {
        EXPECT_FALSE(piece->hasAnisotropicFriction(3));
        EXPECT_EQ(piece->getAnisotropicFriction(), btVector3(1, 1, 1));
    }
}

/// The strengths of a body's material at some places, Pa.
std::vector<double> strengthsOf(const BreakableAsset& asset) {
    std::vector<double> strengths;
    for (double x = -0.4; x < 0.4; x += 0.07) strengths.push_back(asset.tensileStrength({x, 0.5 * x, 0}));
    return strengths;
}

TEST(Inheritance, TheStrengthOfEachPlaceWithTheSeedOfTheBody) {
    const BreakableAsset asset = plate(crumbly(), 0.1);
    std::vector<std::vector<double>> of_bodies = {strengthsOf(asset)};
    for (const std::uint64_t seed : {1, 2}) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        BodyOptions options;
        options.seed = seed;
        const btRigidBody* body = fracture.add(asset, options).value();
        const std::vector<double> own = strengthsOf(*fracture.asset(body));
        for (const std::vector<double>& other : of_bodies) EXPECT_NE(own, other);
        of_bodies.push_back(own);
        scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
        const BlowEvent event = stepUntilBreak(scene, fracture);
        ASSERT_EQ(event.outcome, broke);
        EXPECT_EQ(strengthsOf(event.asset), own);
        for (const btRigidBody* piece : event.fragments) EXPECT_EQ(strengthsOf(*fracture.asset(piece)), own);
    }
}

}  // namespace
