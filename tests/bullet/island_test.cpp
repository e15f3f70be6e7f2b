// What is kept from before a solve, and which bodies a solve joins.

#include <algorithm>

#include "bullet/island/island_state.h"
#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

bool has(const Island& island, const btCollisionObject* object) {
    return std::find(island.bodies.begin(), island.bodies.end(), object) != island.bodies.end();
}

/// Two boxes in contact on a floor, a third joined to the second, and two more apart from these.
struct Yard {
    Yard() : joint(*b, *c, btVector3(1, 0, 0), btVector3(-1, 0, 0)) {
        scene.world->setGravity(btVector3(0, 0, -10));
        scene.world->addConstraint(&joint);
        scene.step(10);
    }
    TestWorld scene;
    btRigidBody* floor = scene.addFloor();
    btRigidBody* a = scene.addBox(1, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.1f));
    btRigidBody* b = scene.addBox(1, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.3f));
    btRigidBody* c = scene.addBox(1, btVector3(0.1f, 0.1f, 0.1f), btVector3(2, 0, 0.3f));
    btRigidBody* d = scene.addBox(1, btVector3(0.1f, 0.1f, 0.1f), btVector3(-2, 0, 0.1f));
    btPoint2PointConstraint joint;
};

TEST(Island, GoesThroughContactsAndJointsButNotThroughTheFloor) {
    Yard yard;
    const Island island = connectedIsland(*yard.scene.world, {yard.a});
    EXPECT_EQ(island.bodies, (std::vector<btCollisionObject*>{yard.a, yard.b, yard.c}));
    EXPECT_EQ(island.constraints, std::vector<btTypedConstraint*>{&yard.joint});
    EXPECT_EQ(island.manifolds.size(), 2u) << "a on the floor, b on a";
    EXPECT_FALSE(has(island, yard.floor));
    const Island other = connectedIsland(*yard.scene.world, {yard.d});
    EXPECT_EQ(other.bodies, std::vector<btCollisionObject*>{yard.d});
    EXPECT_EQ(other.manifolds.size(), 1u);
    yard.scene.world->removeConstraint(&yard.joint);
}

TEST(Snapshot, PutsBackAllThatASolveChangesAndOnlyInTheIsland) {
    Yard yard;
    btDiscreteDynamicsWorld& world = *yard.scene.world;
    const Island island = connectedIsland(world, {yard.a});
    StepSnapshot before;
    before.take(world);
    const btTransform place = yard.a->getWorldTransform();
    const btVector3 velocity = yard.a->getLinearVelocity(), spin = yard.a->getAngularVelocity();

    for (btRigidBody* body : {yard.a, yard.d}) {
        body->setWorldTransform(at(7, 8, 9));
        body->setLinearVelocity(btVector3(1, 2, 3));
        body->setAngularVelocity(btVector3(4, 5, 6));
    }
    yard.joint.setEnabled(false);
    world.removeRigidBody(yard.d);  // Bullet fills the gap with the last of its objects
    before.restore(island);

    EXPECT_TRUE(sameBits(yard.a->getWorldTransform().getOrigin(), place.getOrigin()));
    EXPECT_TRUE(sameBits(yard.a->getLinearVelocity(), velocity));
    EXPECT_TRUE(sameBits(yard.a->getAngularVelocity(), spin));
    EXPECT_TRUE(yard.joint.isEnabled());
    EXPECT_EQ(yard.d->getLinearVelocity().x(), 1) << "not of this island";
    world.removeConstraint(&yard.joint);
}

TEST(Snapshot, PutsBackTheImpulsesThatWarmTheSolverUp) {
    Yard yard;
    const Island island = connectedIsland(*yard.scene.world, {yard.a});
    StepSnapshot before;
    before.take(*yard.scene.world);
    ASSERT_GT(island.manifolds.size(), 0);
    for (btPersistentManifold* manifold : island.manifolds) {
        ASSERT_GT(manifold->getNumContacts(), 0);
        for (int p = 0; p < manifold->getNumContacts(); ++p) {
            btManifoldPoint& point = manifold->getContactPoint(p);
            const btScalar normal = point.m_appliedImpulse, lateral = point.m_appliedImpulseLateral1;
            point.m_appliedImpulse = point.m_appliedImpulseLateral1 = 11;
            before.restore(island);
            EXPECT_EQ(point.m_appliedImpulse, normal);
            EXPECT_EQ(point.m_appliedImpulseLateral1, lateral);
        }
    }
    yard.scene.world->removeConstraint(&yard.joint);
}

/// Two contacts, one of which ends and leaves its place in Bullet's pool to another one.
TEST(Snapshot, GivesNoImpulsesToContactsThatAreNewSince) {
    Yard yard;
    btDiscreteDynamicsWorld& world = *yard.scene.world;
    btDispatcher& dispatcher = *yard.scene.dispatcher;
    btManifoldPoint point(btVector3(0, 0, 0), btVector3(0, 0, 0), btVector3(0, 0, 1), 0);
    point.m_appliedImpulse = 11;
    btPersistentManifold* old = dispatcher.getNewManifold(yard.a, yard.d);
    old->addManifoldPoint(point);
    StepSnapshot before;
    before.take(world);

    dispatcher.releaseManifold(old);
    btPersistentManifold* young = dispatcher.getNewManifold(yard.b, yard.d);
    ASSERT_EQ(young, old) << "the place in the pool is to be the same";
    point.m_appliedImpulse = 3;
    young->addManifoldPoint(point);
    before.restore(connectedIsland(world, {yard.d}));
    EXPECT_EQ(young->getContactPoint(0).m_appliedImpulse, 0) << "11 is the impulse of another contact";
    dispatcher.releaseManifold(young);
    world.removeConstraint(&yard.joint);
}

TEST(Snapshot, GivesNoImpulsesToNewContactsOfTheSameBodies) {
    Yard yard;
    btDiscreteDynamicsWorld& world = *yard.scene.world;
    btDispatcher& dispatcher = *yard.scene.dispatcher;
    btManifoldPoint point(btVector3(0, 0, 0), btVector3(0, 0, 0), btVector3(0, 0, 1), 0);
    point.m_appliedImpulse = 11;
    btPersistentManifold* old = dispatcher.getNewManifold(yard.a, yard.d);
    old->addManifoldPoint(point);
    StepSnapshot before;
    before.take(world);

    // The two parted and met again somewhere else.
    old->clearManifold();
    btManifoldPoint other(btVector3(0.5f, 0, 0), btVector3(0.5f, 0, 0), btVector3(0, 1, 0), 0);
    other.m_appliedImpulse = 3;
    old->addManifoldPoint(other);
    before.restore(connectedIsland(world, {yard.d}));
    EXPECT_EQ(old->getContactPoint(0).m_appliedImpulse, 0);
    dispatcher.releaseManifold(old);
    world.removeConstraint(&yard.joint);
}

TEST(Snapshot, DoesNotTakeANewBodyForOneThatItKnew) {
    Yard yard;
    btDiscreteDynamicsWorld& world = *yard.scene.world;
    StepSnapshot before;
    before.take(world);
    ASSERT_NE(before.find(yard.d), nullptr);
    world.removeRigidBody(yard.d);
    world.addRigidBody(yard.d);  // as if another body had been made at this address
    EXPECT_EQ(before.find(yard.d), nullptr);
    world.removeConstraint(&yard.joint);
}

}  // namespace
