// The app's callback for new fragments.

#include <stdexcept>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A plate that a ball breaks within some steps.
struct BreakingPlate {
    BreakingPlate() {
        BodyOptions options;
        options.name = "plate";
        options.user_pointer = this;
        options.collision_group = 2;
        body = fracture.add(plate(crumbly()), options).value();
        scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    }
    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    btRigidBody* body = nullptr;
};

TEST(FragmentBirth, EachFragmentIsShownBeforeItEntersTheWorld) {
    BreakingPlate test;
    std::vector<btRigidBody*> shown;
    test.fracture.onFragment([&](FragmentBirth& birth) {
        EXPECT_FALSE(inWorld(test.scene, &birth.body));
        EXPECT_TRUE(inWorld(test.scene, &birth.parent));
        EXPECT_EQ(&birth.parent, test.body);
        EXPECT_EQ(birth.event.body, test.body);
        EXPECT_EQ(birth.event.fragments, shown);
        EXPECT_GT(birth.asset.mass(), 0);
        EXPECT_EQ(birth.body.getUserPointer(), &test);
        EXPECT_EQ(birth.name, "plate");
        EXPECT_EQ(birth.collision_group, 2);
        EXPECT_EQ(birth.collision_mask, -1);
        shown.push_back(&birth.body);
    });
    const BlowEvent event = stepUntilBreak(test.scene, test.fracture);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    EXPECT_GE(shown.size(), 2u);
    EXPECT_EQ(shown, event.fragments);
}

TEST(FragmentBirth, WhatTheAppSetsIsKeptButForThePlace) {
    BreakingPlate plain, test;
    int tag = 0;
    btDefaultMotionState motion_states[40];
    std::size_t next = 0;
    test.fracture.onFragment([&](FragmentBirth& birth) {
        birth.body.setUserPointer(&tag);
        birth.body.setUserIndex(int(next));
        birth.body.setFriction(0.11f);
        birth.collision_group = 64;
        birth.collision_mask = 63;
        birth.name += " piece";
        // Bullet moves the body to where the motion state says: the world's origin.
        birth.body.setMotionState(&motion_states[next++]);
    });
    const BlowEvent as_they_are = stepUntilBreak(plain.scene, plain.fracture);
    const BlowEvent event = stepUntilBreak(test.scene, test.fracture);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    ASSERT_EQ(event.fragments.size(), as_they_are.fragments.size());
    for (std::size_t i = 0; i < event.fragments.size(); ++i) {
        const btRigidBody& piece = *event.fragments[i];
        EXPECT_EQ(piece.getUserPointer(), &tag);
        EXPECT_EQ(piece.getUserIndex(), int(i));
        EXPECT_EQ(piece.getFriction(), 0.11f);
        EXPECT_EQ(piece.getBroadphaseHandle()->m_collisionFilterGroup, 64);
        EXPECT_EQ(piece.getBroadphaseHandle()->m_collisionFilterMask, 63);
        EXPECT_EQ(test.fracture.name(&piece), "plate piece");
        EXPECT_EQ(piece.getMotionState(), &motion_states[i]);
        const btVector3 place = as_they_are.fragments[i]->getWorldTransform().getOrigin();
        EXPECT_LT(piece.getWorldTransform().getOrigin().distance(place), 0.02)
            << "drawn back by the callback";
        btTransform drawn;
        motion_states[i].getWorldTransform(drawn);
        EXPECT_LT(drawn.getOrigin().distance(place), 0.05) << "the motion state was not told";
    }
}

TEST(FragmentBirth, WhatTheCallbackThrowsStaysInTheStep) {
    for (const bool with_words : {true, false}) {
        BreakingPlate test;
        int calls = 0;
        test.fracture.onFragment([&](FragmentBirth& birth) {
            birth.body.setUserIndex(++calls);
            if (with_words) throw std::runtime_error("no room in the pool");
            throw 3;
        });
        const BlowEvent event = stepUntilBreak(test.scene, test.fracture);
        ASSERT_EQ(event.outcome, Outcome::broke);
        EXPECT_EQ(calls, int(event.fragments.size()));
        const std::string sentence =
            with_words ? "The fragment callback threw (no room in the pool); the fragment entered the world "
                         "as it was by then."
                       : "The fragment callback threw what is no std::exception; the fragment entered the "
                         "world as it was by then.";
        EXPECT_NE(event.message.find(sentence), std::string::npos) << event.message;
        EXPECT_EQ(event.message.find(sentence), event.message.rfind(sentence)) << "once is enough";
        for (std::size_t i = 0; i < event.fragments.size(); ++i) {
            EXPECT_TRUE(inWorld(test.scene, event.fragments[i]));
            EXPECT_EQ(event.fragments[i]->getUserIndex(), int(i) + 1);
        }
    }
}

TEST(FragmentBirth, CallsFromTheCallbackAreAnsweredAsInsideAStep) {
    BreakingPlate test;
    const BreakableAsset asset = plate(unbreakable());
    btRigidBody* other = test.fracture.add(asset, at(0, 0, 5)).value();
    std::string refusal;
    test.fracture.onFragment([&](FragmentBirth&) {
        refusal = test.fracture.add(asset, at(0, 0, 9)).error();
        EXPECT_TRUE(test.fracture.takeEvents().empty());
        test.fracture.remove(other);
        EXPECT_TRUE(inWorld(test.scene, other));
    });
    // Between steps, too: the break is inside a call.
    ASSERT_TRUE(test.fracture.applyBlow(test.body, {btVector3(0, 0, 0.03f), btVector3(0, 0, -50)}).ok());
    EXPECT_EQ(refusal,
              "a body cannot be added while the world is inside a step; add it after stepSimulation");
    EXPECT_FALSE(inWorld(test.scene, other));
    EXPECT_EQ(test.fracture.takeEvents().size(), 1u);
}

TEST(FragmentBirth, AStepFromTheCallbackIsRefused) {
    BreakingPlate test;
    int ticks = 0;
    test.scene.world->setInternalTickCallback(
        [](btDynamicsWorld* w, btScalar) { ++*static_cast<int*>(w->getWorldUserInfo()); }, &ticks, true);
    test.fracture.onFragment([&](FragmentBirth&) { test.scene.step(1); });
    const BlowEvent event = stepUntilBreak(test.scene, test.fracture);
    ASSERT_EQ(event.outcome, Outcome::broke);
    EXPECT_NE(event.message.find("stepSimulation must not be called from a FragmentCallback"),
              std::string::npos)
        << event.message;
    for (const btRigidBody* fragment : event.fragments) EXPECT_TRUE(inWorld(test.scene, fragment));
    ticks = 0;
    test.scene.step(3);
    EXPECT_EQ(ticks, 3) << "the app's own callback is back";
}

TEST(FragmentBirth, ACallbackMayEndItself) {
    BreakingPlate test;
    const std::vector<int> captured(1000, 7);
    int sum = 0, calls = 0;
    test.fracture.onFragment([&test, &sum, &calls, captured](FragmentBirth&) {
        test.fracture.onFragment(nullptr);
        ++calls;
        for (const int number : captured) sum += number;  // still there
    });
    ASSERT_TRUE(test.fracture.applyBlow(test.body, {btVector3(0, 0, 0.03f), btVector3(0, 0, -50)}).ok());
    EXPECT_EQ(calls, 1) << "counts from the next fragment on";
    EXPECT_EQ(sum, 7000);
}

TEST(FragmentBirth, AFragmentThatIsBeingBornTakesCallsAsAnyBody) {
    for (const bool in_step : {false, true}) {
        BreakingPlate test;
        int born = 0;
        std::string refusal;
        test.fracture.onFragment([&](FragmentBirth& birth) {
            EXPECT_EQ(test.fracture.asset(&birth.body), &birth.asset);
            EXPECT_EQ(test.fracture.name(&birth.body), "plate");
            if (++born % 2) return test.fracture.remove(&birth.body);
            const Push push{birth.body.getCenterOfMassPosition(), btVector3(1000, 0, 0)};
            refusal += test.fracture.applyBlow(&birth.body, push).error();
        });
        if (!in_step) {
            ASSERT_TRUE(
                test.fracture.applyBlow(test.body, {btVector3(0, 0, 0.03f), btVector3(0, 0, -50)}).ok());
        }
        const BlowEvent event =
            in_step ? stepUntilBreak(test.scene, test.fracture) : std::move(test.fracture.takeEvents().at(0));
        EXPECT_GT(born, 2);
        EXPECT_EQ(refusal, "");
        EXPECT_EQ(int(test.fracture.bodies().size()), born / 2) << "remove waits for the end of the step";
        EXPECT_EQ(event.fragments, test.fracture.bodies());
        for (const btRigidBody* piece : event.fragments)
            EXPECT_GT(piece->getLinearVelocity().x() / piece->getInvMass(), 900) << "so does a blow";
    }
}

TEST(FragmentBirth, NoFragmentIsWithoutAShape) {
    BreakingPlate test;
    test.fracture.onFragment([](FragmentBirth& birth) { birth.body.setCollisionShape(nullptr); });
    const BlowEvent event = stepUntilBreak(test.scene, test.fracture);
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    for (const btRigidBody* piece : event.fragments) EXPECT_TRUE(piece->getCollisionShape());
    test.scene.step(10);
}

TEST(FragmentBirth, TheExtensionPointerStaysSherds) {
    BreakingPlate test;
    int tag = 0;
    test.fracture.onFragment([&](FragmentBirth& birth) { birth.body.internalSetExtensionPointer(&tag); });
    ASSERT_TRUE(test.fracture.applyBlow(test.body, {btVector3(0, 0, 0.03f), btVector3(0, 0, -50)}).ok());
    for (btRigidBody* piece : test.fracture.bodies()) test.fracture.remove(piece);
    EXPECT_TRUE(test.fracture.bodies().empty());
}

}  // namespace
