#include "bullet/fragments/body_removal.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>

#include "bullet/bodies/breakable.h"
#include "bullet/bodies/joint_anchors.h"
#include "bullet/island/other_joints.h"
#include "bullet/world/world_internals.h"

namespace sherd {

namespace {

/// The manifolds of Bullet's contact prediction belong to no collision pair, so removing the body leaves
/// them.
void releasePredictiveContacts(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    auto& manifolds = WorldInternals::predictiveManifolds(world);
    for (int i = manifolds.size() - 1; i >= 0; --i) {
        btPersistentManifold* manifold = manifolds[i];
        if (manifold->getBody0() != &body && manifold->getBody1() != &body) continue;
        manifolds.removeAtIndex(i);
        world.getDispatcher()->releaseManifold(manifold);
    }
}

void activateNeighbours(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
        if (a == &body) b->activate();
        if (b == &body) a->activate();
    }
}

std::vector<btTypedConstraint*> removeJoints(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    std::vector<btTypedConstraint*> removed;
    for (int i = world.getNumConstraints() - 1; i >= 0; --i) {
        btTypedConstraint* constraint = world.getConstraint(i);
        if (&constraint->getRigidBodyA() != &body && &constraint->getRigidBodyB() != &body) continue;
        constraint->getRigidBodyA().activate();
        constraint->getRigidBodyB().activate();
        world.removeConstraint(constraint);
        noteRemovedJoint(*constraint);
        removed.push_back(constraint);
    }
    std::reverse(removed.begin(), removed.end());
    return removed;
}

void endExceptionsFor(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        for (int k = objects[i]->getNumObjectsWithoutCollision() - 1; k >= 0; --k)
            if (objects[i]->getObjectWithoutCollision(k) == &body)
                objects[i]->setIgnoreCollisionCheck(&body, false);
}

}  // namespace

RemovedJoints detachFromWorld(btDiscreteDynamicsWorld& world, Breakable& breakable) {
    RemovedJoints joints{removeJoints(world, *breakable.body),
                         removeMultiBodyConstraints(world, *breakable.body)};
    detachSoftBodies(world, *breakable.body);
    if (!breakable.ownedHere()) return joints;
    for (btTypedConstraint* joint : joints.constraints) joint->setEnabled(false);
    endExceptionsFor(world, *breakable.body);
    return joints;
}

RemovedJoints removeFromWorld(btDiscreteDynamicsWorld& world, Breakable& breakable) {
    activateNeighbours(world, *breakable.body);
    RemovedJoints joints = detachFromWorld(world, breakable);
    releasePredictiveContacts(world, *breakable.body);
    world.removeRigidBody(breakable.body);
    return joints;
}

}  // namespace sherd
