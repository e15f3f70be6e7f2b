// What is kept from before a solve, and which bodies a solve joins.

#include <algorithm>

#include "bullet/island_state.h"
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
    for (btPersistentManifold* manifold : island.manifolds) {
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

}  // namespace
