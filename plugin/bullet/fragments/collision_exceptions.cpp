#include "bullet/fragments/collision_exceptions.h"

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>

#include "bullet/bodies/breakable.h"

namespace sherd {

namespace {

/// How often an object is told not to collide with another one.
int exceptionCount(btCollisionObject& object, const btCollisionObject* other) {
    int count = 0;
    for (int i = 0; i < object.getNumObjectsWithoutCollision(); ++i)
        count += object.getObjectWithoutCollision(i) == other;
    return count;
}

/// Of these, how often by a joint between the two: one each in both lists.
int jointCount(btRigidBody& body, const btCollisionObject* other) {
    int count = 0;
    for (int i = 0; i < body.getNumConstraintRefs(); ++i) {
        const btTypedConstraint& joint = *body.getConstraintRef(i);
        count += &joint.getRigidBodyA() == other || &joint.getRigidBodyB() == other;
    }
    return count;
}

}  // namespace

void inheritCollisionExceptions(btDiscreteDynamicsWorld& world, const Breakable& parent,
                                const std::vector<std::unique_ptr<Breakable>>& fragments) {
    btRigidBody& whole = *parent.body;
    std::vector<const btCollisionObject*> partners;
    const auto add = [&](const btCollisionObject* other) {
        if (std::find(partners.begin(), partners.end(), other) == partners.end()) partners.push_back(other);
    };
    // Objects in the list of the whole may be in no world, or dead: they are compared only.
    for (int i = 0; i < whole.getNumObjectsWithoutCollision(); ++i) {
        const btCollisionObject* other = whole.getObjectWithoutCollision(i);
        if (exceptionCount(whole, other) > jointCount(whole, other)) add(other);
    }
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (exceptionCount(*objects[i], &whole) > jointCount(whole, objects[i])) add(objects[i]);
    for (const auto& fragment : fragments)
        for (const btCollisionObject* other : partners) fragment->body->setIgnoreCollisionCheck(other, true);
}

}  // namespace sherd
