// What a program has made of a body, and the body does not break by, is said with the next blow on it.

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A box of the program's own that flies at the floor.
struct OwnBox {
    OwnBox() {
        scene.addFloor();
        body.setWorldTransform(at(0, 0, 0.7f));
        body.setLinearVelocity(btVector3(0, 0, -4));
        scene.world->addRigidBody(&body);
    }
    ~OwnBox() {
        fracture = nullptr;
        if (body.isInWorld()) scene.world->removeRigidBody(&body);
    }
    BlowEvent firstBlow() { return stepUntilBreak(scene, *fracture); }

    TestWorld scene;
    btBoxShape box{btVector3(0.1f, 0.1f, 0.3f)}, larger{btVector3(0.12f, 0.1f, 0.3f)};
    btRigidBody body{btRigidBody::btRigidBodyConstructionInfo(5, nullptr, &box, btVector3(1, 1, 1))};
    std::unique_ptr<FractureWorld> fracture = std::make_unique<FractureWorld>(scene.world.get());
};

BreakableAsset cylinderAsset() {
    Settings settings = coarse(0.03);
    settings.fracture.smallest_fragment_m3 = 0;
    return BreakableAsset::fromMesh(cylinderMesh(0.1, 0.1), crumbly(), settings).value();
}

TEST(BodyWarnings, ABodyThatTurnsAboutAnotherPointSaysIt) {
    for (const btScalar shift : {btScalar(0), btScalar(0.1)}) {
        OwnBox own;
        btCompoundShape shape;
        shape.addChildShape(at(0, 0, shift), &own.box);
        own.body.setCollisionShape(&shape);
        ASSERT_TRUE(own.fracture->makeBreakable(&own.body, crumbly(), coarse(0.06)).ok());
        EXPECT_EQ(warnsOf(own.firstBlow(), "100 mm from the centre of its solid"), shift > 0);
    }
}

// Every body of an asset shares the shape, so all of them grow; the pieces would not.
TEST(BodyWarnings, AScaledShapeOfAnAssetSaysIt) {
    const BreakableAsset asset = cylinderAsset();
    for (const bool scaled : {false, true}) {
        TestWorld scene;
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(asset, at(0, 0, 0.3f)).value();
        if (scaled) body->getCollisionShape()->setLocalScaling(btVector3(2, 2, 2));
        body->setLinearVelocity(btVector3(0, 0, -4));
        const BlowEvent blow = stepUntilBreak(scene, fracture);
        EXPECT_EQ(blow.outcome, Outcome::broke);
        EXPECT_EQ(warnsOf(blow, "setLocalScaling"), scaled);
    }
}

TEST(BodyWarnings, AMassThatIsNotTheAssetsSaysItAndThePiecesDoNot) {
    const BreakableAsset asset = cylinderAsset();
    for (const double share : {1.0, 0.2}) {
        TestWorld scene;
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(asset, at(0, 0, 0.3f)).value();
        body->setMassProps(btScalar(share * asset.mass()), body->getLocalInertia() * btScalar(share));
        body->setLinearVelocity(btVector3(0, 0, -4));
        const BlowEvent blow = stepUntilBreak(scene, fracture);
        EXPECT_EQ(blow.outcome, Outcome::broke);
        EXPECT_EQ(warnsOf(blow, "Material::withDensity"), share < 1);
        scene.step(60);  // pieces rest after their birth
        fracture.takeEvents();
        for (btRigidBody* piece : fracture.bodies())
            (void)fracture.applyBlow(
                piece, Push{piece->getCenterOfMassPosition(), btVector3(0, 0, -10 / piece->getInvMass())});
        const auto of_pieces = fracture.takeEvents();
        EXPECT_FALSE(of_pieces.empty());
        for (const BlowEvent& event : of_pieces) EXPECT_FALSE(warnsOf(event, "The mass of this body"));
    }
}

TEST(BodyWarnings, AShapeThatChangesAfterMakeBreakableSaysIt) {
    enum class Change { none, margin, scaled, replaced, moved };
    for (const Change change :
         {Change::none, Change::margin, Change::scaled, Change::replaced, Change::moved}) {
        OwnBox own;
        btCompoundShape shape;
        shape.addChildShape(at(0, 0, 0), &own.box);
        own.body.setCollisionShape(&shape);
        ASSERT_TRUE(own.fracture->makeBreakable(&own.body, crumbly(), coarse(0.06)).ok());
        if (change == Change::margin) shape.setMargin(0.01f);
        if (change == Change::scaled) shape.setLocalScaling(btVector3(1, 1, 1.1f));
        if (change == Change::replaced) own.body.setCollisionShape(&own.larger);
        if (change == Change::moved) shape.updateChildTransform(0, at(0.01f, 0, 0));
        const bool is_other = change != Change::none && change != Change::margin;
        EXPECT_EQ(warnsOf(own.firstBlow(), "scaled, moved or replaced after makeBreakable"), is_other);
    }
}

TEST(BodyWarnings, AMassThatChangesAfterMakeBreakableSaysItUntilThatIsCalledAgain) {
    for (const bool again : {false, true}) {
        OwnBox own;
        ASSERT_TRUE(own.fracture->makeBreakable(&own.body, crumbly(), coarse(0.06)).ok());
        own.body.setMassProps(10, btVector3(2, 2, 2));
        if (again) {
            own.fracture->remove(&own.body);
            ASSERT_TRUE(own.fracture->makeBreakable(&own.body, crumbly(), coarse(0.06)).ok());
        }
        EXPECT_EQ(warnsOf(own.firstBlow(), "The mass of this body was set to 10 kg"), !again);
    }
}

TEST(BodyWarnings, WhatChangesAfterABlowIsSaidOnceByTheNext) {
    OwnBox own;
    Settings settings = coarse(0.06);
    settings.fracture.check_with_full_solve = true;  // with that each blow has an event
    ASSERT_TRUE(own.fracture->makeBreakable(&own.body, unbreakable(), settings).ok());
    own.scene.world->setGravity(btVector3(0, 0, 0));
    const auto pushed = [&] {
        (void)own.fracture->applyBlow(
            &own.body, Push{own.body.getCenterOfMassPosition(), btVector3(0, 0, 20 / own.body.getInvMass())});
        return warnsOf(own.fracture->takeEvents().at(0), "The mass of this body");
    };
    EXPECT_FALSE(pushed());
    own.body.setMassProps(10, btVector3(2, 2, 2));
    EXPECT_TRUE(pushed());
    EXPECT_FALSE(pushed());
}

}  // namespace
