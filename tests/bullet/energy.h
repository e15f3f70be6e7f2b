#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <vector>

namespace sherd::bullet_tests {

/// Kinetic and potential, of all bodies together, J. The potential is zero at the origin of the world.
inline double energyOf(const std::vector<btRigidBody*>& bodies) {
    double sum = 0;
    for (const btRigidBody* body : bodies) {
        const btVector3 v = body->getLinearVelocity(), w = body->getAngularVelocity();
        const double mass = 1 / body->getInvMass();
        sum += 0.5 * (mass * v.length2() + w.dot(body->getInvInertiaTensorWorld().inverse() * w)) -
               mass * body->getGravity().dot(body->getCenterOfMassPosition());
    }
    return sum;
}

}  // namespace sherd::bullet_tests
