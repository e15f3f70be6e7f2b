#include "bullet/joint_anchors.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <mutex>
#include <vector>

namespace sherd {

namespace {

struct Anchors {
    std::mutex mutex;  // worlds may be stepped on several threads
    std::vector<std::unique_ptr<btRigidBody>> bodies;
};

/// Never destroyed, since joints and worlds of the app's may be static objects, too.
Anchors& anchors() {
    static Anchors& all = *new Anchors;
    return all;
}

}  // namespace

void keepForJoints(std::unique_ptr<btRigidBody> body) {
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
