// Joints of the app's outlive the bodies that they hold: whatever was removed, broken or destroyed, a joint
// can be asked, removed and deleted at any time. To be run under valgrind or with address checks, too.

#include <functional>
#include <memory>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

using MakeJoint = std::unique_ptr<btTypedConstraint> (*)(btRigidBody&, btRigidBody&);

const btTransform right_end = at(0.35f, 0, 0), left_end = at(-0.15f, 0, 0);
const btVector3 up(0, 0, 1);

struct Kind {
    const char* name;
    MakeJoint make;

    friend void PrintTo(const Kind& self, std::ostream* out) { *out << self.name; }
};
const Kind kinds[] = {
    {"point",
     [](btRigidBody& a, btRigidBody& b) -> std::unique_ptr<btTypedConstraint> {
         return std::make_unique<btPoint2PointConstraint>(a, b, right_end.getOrigin(), left_end.getOrigin());
     }},
    {"hinge",
     [](btRigidBody& a, btRigidBody& b) -> std::unique_ptr<btTypedConstraint> {
         return std::make_unique<btHingeConstraint>(a, b, right_end.getOrigin(), left_end.getOrigin(), up,
                                                    up);
     }},
    {"slider",
     [](btRigidBody& a, btRigidBody& b) -> std::unique_ptr<btTypedConstraint> {
         return std::make_unique<btSliderConstraint>(a, b, right_end, left_end, true);
     }},
    {"cone_twist",
     [](btRigidBody& a, btRigidBody& b) -> std::unique_ptr<btTypedConstraint> {
         return std::make_unique<btConeTwistConstraint>(a, b, right_end, left_end);
     }},
    {"fixed",
     [](btRigidBody& a, btRigidBody& b) -> std::unique_ptr<btTypedConstraint> {
         return std::make_unique<btFixedConstraint>(a, b, right_end, left_end);
     }},
    {"spring",
     [](btRigidBody& a, btRigidBody& b) -> std::unique_ptr<btTypedConstraint> {
         return std::make_unique<btGeneric6DofSpring2Constraint>(a, b, right_end, left_end);
     }},
};

/// A plate that hangs on a weight by a joint, as its first or as its second body.
class JointOf : public testing::TestWithParam<std::tuple<Kind, bool>> {
  protected:
    JointOf() {
        body = fracture->add(plate(crumbly(), 0.1), at(0, 0, 0)).value();
        weight = scene.addBox(1, btVector3(0.05f, 0.05f, 0.05f), btVector3(0.5f, 0, 0));
        const auto& [kind, plate_first] = GetParam();
        joint = plate_first ? kind.make(*body, *weight) : kind.make(*weight, *body);
        scene.world->addConstraint(joint.get(), true);
        scene.step(2);
    }
    ~JointOf() override {
        // The order that an app's wrapper of a joint has.
        scene.world->removeConstraint(joint.get());
        joint.reset();
        scene.step(2);
    }
    /// What takes memory takes that which was freed.
    void churn() {
        std::vector<std::unique_ptr<btRigidBody>> bodies;
        btSphereShape shape(1);
        for (int i = 0; i < 50; ++i)
            bodies.push_back(std::make_unique<btRigidBody>(btScalar(7), nullptr, &shape, btVector3(1, 1, 1)));
    }
    void expectHarmless() {
        churn();
        EXPECT_FALSE(joint->isEnabled());
        EXPECT_EQ(scene.world->getNumConstraints(), 0);
        EXPECT_EQ(weight->getNumConstraintRefs(), 0);
        const bool plate_first = std::get<1>(GetParam());
        const btRigidBody& dead = plate_first ? joint->getRigidBodyA() : joint->getRigidBodyB();
        EXPECT_EQ(dead.getInvMass(), 0);
        EXPECT_TRUE(dead.isStaticObject());
        EXPECT_EQ(dead.getCollisionShape(), nullptr) << "only the shell of the body is kept";
        EXPECT_EQ(dead.getNumConstraintRefs(), 0);
        // An app that forgets that the joint is gone gets one to a fixed place, and no crash.
        scene.world->addConstraint(joint.get(), true);
        scene.step(2);
        joint->setEnabled(true);
        scene.step(2);
        EXPECT_TRUE(std::isfinite(weight->getCenterOfMassPosition().x()));
    }

    TestWorld scene;
    std::unique_ptr<FractureWorld> fracture = std::make_unique<FractureWorld>(scene.world.get());
    btRigidBody *body = nullptr, *weight = nullptr;
    std::unique_ptr<btTypedConstraint> joint;
};

TEST_P(JointOf, ARemovedBody) {
    fracture->remove(body);
    scene.step(3);
    expectHarmless();
}

TEST_P(JointOf, ARemovedBodyAtOnce) {
    fracture->remove(body);
    scene.world->removeConstraint(joint.get());
}

TEST_P(JointOf, ABrokenBody) {
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    const BlowEvent event = stepUntilBreak(scene, *fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_EQ(event.removed_constraints, std::vector<btTypedConstraint*>{joint.get()});
    EXPECT_EQ(event.body->getNumConstraintRefs(), 0);
    scene.step(3);
    fracture->takeEvents();
    scene.step(3);
    expectHarmless();
}

TEST_P(JointOf, ABodyOfAWorldThatIsNotHookedAnyMore) {
    fracture.reset();
    expectHarmless();
}

TEST_P(JointOf, ABodyThatBrokeBeforeTheWorldWasUnhooked) {
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    scene.step(20);
    ASSERT_GT(fracture->bodies().size(), 1u);
    fracture.reset();  // with an event that nobody has taken
    expectHarmless();
}

TEST_P(JointOf, ABodyThatTheAppTookOut) {
    scene.world->removeRigidBody(body);  // and leaves the joint where it is
    fracture.reset();
    expectHarmless();
}

INSTANTIATE_TEST_SUITE_P(Kinds, JointOf, testing::Combine(testing::ValuesIn(kinds), testing::Bool()),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) +
                                    (std::get<1>(info.param) ? "_first" : "_second");
                         });

TEST(Joints, OfAnAppsBodyThatBreaksAreNamedAndStayAsTheyWere) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = scene.addBox(7, btVector3(0.3f, 0.3f, 0.03f), btVector3(0, 0, 0));
    ASSERT_TRUE(fracture.makeBreakable(body, crumbly(), coarse(0.1)).ok());
    btRigidBody* weight = scene.addBox(1, btVector3(0.05f, 0.05f, 0.05f), btVector3(0.5f, 0, 0));
    btPoint2PointConstraint joint(*body, *weight, right_end.getOrigin(), left_end.getOrigin());
    scene.world->addConstraint(&joint, true);
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    ASSERT_EQ(stepUntilBreak(scene, fracture).outcome, broke);
    EXPECT_TRUE(joint.isEnabled()) << "the body is the app's, and may come back with its joints";
    EXPECT_EQ(scene.world->getNumConstraints(), 0);
    EXPECT_EQ(body->getCollisionShape() != nullptr, true);
    scene.world->removeConstraint(&joint);
}

/// Two plates of Sherd's that a joint holds together.
struct TwoPlates {
    TwoPlates() {
        scene.world->addConstraint(&joint, true);
        scene.step(2);
    }
    /// What takes memory takes that which was freed; then the app's wrapper of the joint goes.
    ~TwoPlates() {
        std::vector<std::unique_ptr<btRigidBody>> bodies;
        btSphereShape shape(1);
        for (int i = 0; i < 50; ++i)
            bodies.push_back(std::make_unique<btRigidBody>(btScalar(7), nullptr, &shape, btVector3(1, 1, 1)));
        for (const btRigidBody* body : {&joint.getRigidBodyA(), &joint.getRigidBodyB()}) {
            EXPECT_EQ(body->getInvMass(), 0) << "it was freed, and another body stands in its place";
            EXPECT_EQ(body->getCollisionShape(), nullptr) << "only the shell of the body is kept";
            EXPECT_EQ(body->getNumConstraintRefs(), 0);
        }
        scene.world->removeConstraint(&joint);
        scene.step(2);
    }

    TestWorld scene;
    std::unique_ptr<FractureWorld> fracture = std::make_unique<FractureWorld>(scene.world.get());
    BreakableAsset asset = plate(crumbly(), 0.1);
    btRigidBody* a = fracture->add(asset, at(0, 0, 0)).value();
    btRigidBody* b = fracture->add(asset, at(0.7f, 0, 0)).value();
    btPoint2PointConstraint joint{*a, *b, btVector3(0.35f, 0, 0), btVector3(-0.35f, 0, 0)};
};

TEST(JointOfTwoBreakables, OutlivesBothIfTheyAreRemoved) {
    for (const bool first : {true, false}) {
        TwoPlates plates;
        plates.fracture->remove(first ? plates.a : plates.b);
        plates.scene.step(3);
        plates.fracture->remove(first ? plates.b : plates.a);
        plates.scene.step(3);
    }
}

TEST(JointOfTwoBreakables, OutlivesBothIfTheyBreak) {
    TwoPlates plates;
    for (btRigidBody* body : {plates.a, plates.b}) {
        const btVector3 top = body->getCenterOfMassPosition() + btVector3(0, 0, 0.03f);
        ASSERT_TRUE(plates.fracture->applyBlow(body, {top, btVector3(0, 0, -50)}).ok());
    }
    plates.scene.step(2);
    const std::vector<BlowEvent> events = plates.fracture->takeEvents();
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].removed_constraints, std::vector<btTypedConstraint*>{&plates.joint});
    EXPECT_TRUE(events[1].removed_constraints.empty());
    plates.scene.step(3);
}

TEST(JointOfTwoBreakables, OutlivesTheFractureWorld) {
    TwoPlates plates;
    plates.fracture.reset();
}

TEST(JointOfTwoBreakables, OutlivesTheirTwoFractureWorlds) {
    TwoPlates plates;
    FractureWorld second(plates.scene.world.get());
    btRigidBody* c = second.add(plates.asset, at(0, 2, 0)).value();
    btPoint2PointConstraint joint(*plates.a, *c, btVector3(0, 1, 0), btVector3(0, -1, 0));
    plates.scene.world->addConstraint(&joint);
    plates.fracture.reset();
    second.remove(c);
    plates.scene.step(3);
    EXPECT_EQ(joint.getRigidBodyB().getCollisionShape(), nullptr) << "only the shell of the body is kept";
    plates.scene.world->removeConstraint(&joint);
}

}  // namespace
