// What stays breakable, and what is another body: a body is itself wherever it goes, and whatever it is
// given.

#include <optional>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

/// A box of the app's that is breakable, in a place of memory that it does not have for ever.
struct AppsBox {
    AppsBox() {
        place.emplace(info);
        scene.world->addRigidBody(body());
    }
    ~AppsBox() {
        if (place) scene.world->removeRigidBody(body());
    }
    btRigidBody* body() { return &*place; }
    /// A ball from above breaks what is breakable.
    bool breaks() {
        scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
        return stepUntilBreak(scene, fracture, 60).outcome == broke;
    }

    btBoxShape shape{btVector3(0.3f, 0.3f, 0.03f)};
    btRigidBody::btRigidBodyConstructionInfo info{btScalar(8), nullptr, &shape, btVector3(0.2f, 0.2f, 0.2f)};
    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    std::optional<btRigidBody> place;
};

TEST(Identity, BodyIsItselfAfterItWasOutForSteps) {
    AppsBox box;
    ASSERT_TRUE(box.fracture.makeBreakable(box.body(), crumbly(), coarse(0.1)).ok());
    box.scene.world->removeRigidBody(box.body());
    box.scene.step(3);
    EXPECT_TRUE(box.fracture.bodies().empty());
    box.scene.world->addRigidBody(box.body());
    EXPECT_NE(box.fracture.asset(box.body()), nullptr);
    EXPECT_EQ(box.fracture.bodies().size(), 1u);
    EXPECT_TRUE(box.breaks());
}

TEST(Identity, BodyIsItselfWithAnotherMass) {
    // The order that Bullet asks for.
    AppsBox box;
    ASSERT_TRUE(box.fracture.makeBreakable(box.body(), crumbly(), coarse(0.1)).ok());
    box.scene.world->removeRigidBody(box.body());
    box.body()->setMassProps(16, btVector3(0.4f, 0.4f, 0.4f));
    box.body()->updateInertiaTensor();
    box.scene.world->addRigidBody(box.body());
    EXPECT_NE(box.fracture.asset(box.body()), nullptr);
    EXPECT_TRUE(box.breaks());
    double mass = 0;
    for (const btRigidBody* piece : box.fracture.bodies()) mass += 1.0 / piece->getInvMass();
    EXPECT_NEAR(mass, 16, 1e-4);
}

TEST(Identity, NewBodyAtTheAddressOfAnOldOneIsAnother) {
    AppsBox box;
    ASSERT_TRUE(box.fracture.makeBreakable(box.body(), crumbly(), coarse(0.1)).ok());
    box.scene.step();
    btRigidBody* const address = box.body();
    box.scene.world->removeRigidBody(box.body());
    box.place.emplace(box.info);  // the same shape and the same mass
    ASSERT_EQ(box.body(), address);
    box.scene.world->addRigidBody(box.body());
    EXPECT_EQ(box.fracture.asset(box.body()), nullptr);
    EXPECT_TRUE(box.fracture.bodies().empty());
    EXPECT_FALSE(box.breaks());
    const Status made = box.fracture.makeBreakable(box.body(), crumbly(), coarse(0.1));
    EXPECT_TRUE(made.ok()) << "it may become breakable in its own right: " << made.error();
    EXPECT_EQ(box.fracture.bodies().size(), 1u);
}

TEST(Identity, BodyKnowsOtherWorldsApart) {
    AppsBox box;
    ASSERT_TRUE(box.fracture.makeBreakable(box.body(), crumbly(), coarse(0.1)).ok());
    FractureWorld second(box.scene.world.get());
    EXPECT_EQ(second.asset(box.body()), nullptr);
    EXPECT_TRUE(second.bodies().empty());
    EXPECT_EQ(second.makeBreakable(box.body(), crumbly(), coarse(0.1)).error(),
              "the body is breakable already, by another FractureWorld of this world");
}

TEST(Identity, RemoveEndsThatAnAppsBodyIsBreakable) {
    AppsBox box;
    ASSERT_TRUE(box.fracture.makeBreakable(box.body(), crumbly(), coarse(0.1)).ok());
    box.fracture.remove(box.body());
    EXPECT_EQ(box.fracture.asset(box.body()), nullptr);
    EXPECT_TRUE(inWorld(box.scene, box.body())) << "it goes on as a body of the app's";
    EXPECT_FALSE(box.breaks());
}

TEST(Identity, BodyWhoseMarkIsTakenIsRefused) {
    AppsBox box;
    int apps_own = 0;
    // Also with an index of the app's that is as small as the first marks.
    ASSERT_TRUE(box.fracture.add(plate(crumbly(), 0.1), at(0, 0, 5)).ok());
    for (void* const own : {static_cast<void*>(&apps_own), reinterpret_cast<void*>(std::uintptr_t(1))}) {
        box.body()->internalSetExtensionPointer(own);
        const Status made = box.fracture.makeBreakable(box.body(), crumbly(), coarse(0.1));
        ASSERT_FALSE(made.ok());
        EXPECT_NE(made.error().find("extension pointer"), std::string::npos) << made.error();
        EXPECT_EQ(box.fracture.asset(box.body()), nullptr);
        EXPECT_EQ(box.body()->internalGetExtensionPointer(), own);
    }
}

// What a game asks of a body that it kept the address of.
TEST(Identity, NoBodyAndABodyThatIsGoneAreNotBreakable) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto body = fracture.add(plate(Material::plaster()), at(0, 0, 2));
    ASSERT_TRUE(body.ok()) << body.error();
    const btRigidBody* gone = body.value();
    fracture.remove(body.value());
    scene.step(3, 1.0 / 60);
    fracture.takeEvents();
    scene.step(3, 1.0 / 60);
    for (const btRigidBody* none : {gone, static_cast<const btRigidBody*>(nullptr)}) {
        EXPECT_EQ(fracture.asset(none), nullptr);
        EXPECT_EQ(fracture.name(none), "");
    }
    fracture.remove(nullptr);
    EXPECT_TRUE(fracture.bodies().empty());
}

}  // namespace
