#include "bullet/bodies/joint_anchors.h"

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <mutex>
#include <unordered_set>
#include <vector>

namespace sherd {

namespace {

struct Anchors {
    std::mutex mutex;                     // worlds may be stepped on several threads
    std::unordered_set<BodyToken> named;  // by removed joints; for look-up only
    std::vector<std::unique_ptr<btRigidBody>> bodies;
};

/// Never destroyed, since joints and worlds of the app's may be static objects, too.
Anchors& anchors() {
    static Anchors& all = *new Anchors;
    return all;
}

/// Whether removed joints name the body; from now on they count as none.
bool takeNamed(BodyToken body) {
    const std::lock_guard<std::mutex> lock(anchors().mutex);
    return anchors().named.erase(body) > 0;
}

}  // namespace

void noteRemovedJoint(const btTypedConstraint& joint) {
    const std::lock_guard<std::mutex> lock(anchors().mutex);
    for (const btRigidBody* body : {&joint.getRigidBodyA(), &joint.getRigidBodyB()})
        if (const BodyToken token = tokenOf(*body); token != no_token) anchors().named.insert(token);
}

void keepForJoints(std::unique_ptr<btRigidBody> body, BodyToken token) {
    if (!takeNamed(token) || !body) return;
    const btVector3 none(0, 0, 0);
    body->setMassProps(0, none);
    body->updateInertiaTensor();
    body->setLinearVelocity(none);
    body->setAngularVelocity(none);
    body->clearForces();
    body->setCollisionShape(nullptr);
    body->setMotionState(nullptr);
    const std::lock_guard<std::mutex> lock(anchors().mutex);
    anchors().bodies.push_back(std::move(body));
}

}  // namespace sherd
