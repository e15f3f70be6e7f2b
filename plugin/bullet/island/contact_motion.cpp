#include "bullet/island/contact_motion.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>

#include "bullet/island/multi_body_state.h"
#include "bullet/world/conversions.h"

namespace sherd {

BodyState stateOf(const btRigidBody& body) {
    return {&body, body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity()};
}

bool falls(const btRigidBody& body, const btVector3& velocity, double time_step_s) {
    const btVector3& gravity = body.getGravity();
    return std::abs(velocity.dot(gravity)) > time_step_s / 2 * gravity.length2();
}

bool canMove(const btRigidBody& body) {
    return !body.isStaticOrKinematicObject() && body.getInvMass() > 0;
}

bool givesWay(const btCollisionObject& object) {
    const btRigidBody* body = btRigidBody::upcast(&object);
    return body && canMove(*body);
}

PointMotion motionAt(const btCollisionObject& object, const BodyState* state, const btVector3& point,
                     const btVector3& normal, double time_step_s) {
    PointMotion motion;
    btScalar unused = 0;
    if (const btRigidBody* body = btRigidBody::upcast(&object)) {
        const btVector3 linear = state ? state->linear : body->getLinearVelocity();
        motion.velocity = state ? state->velocityAt(point)
                                : body->getVelocityInLocalPoint(point - body->getCenterOfMassPosition());
        if (!canMove(*body)) return motion;
        motion.gravity = body->getGravity().dot(normal);
        motion.fall = falls(*body, linear, time_step_s) ? motion.gravity : 0;
    } else {
        linkMotion(object, point, motion.velocity, unused);
    }
    return motion;
}

double speedOfTouch(double closing_m_s, double gravity_m_s2, double depth_m, double time_step_s) {
    const double now = closing_m_s + gravity_m_s2 * time_step_s / 2;
    const double way = std::clamp(depth_m, -now * time_step_s, now * time_step_s);
    return std::sqrt(std::max(now * now - 2 * gravity_m_s2 * way, closing_m_s * closing_m_s / 4));
}

double timeSinceTouch(double closing_m_s, double depth_m, double time_step_s) {
    return closing_m_s > 0 ? std::clamp(depth_m / closing_m_s, -time_step_s, time_step_s) : 0;
}

double slowestStrike(const PointMotion& a, const PointMotion& b, double time_step_s) {
    constexpr double resting_steps = 2;
    return resting_steps * time_step_s * std::max(std::abs(a.gravity), std::abs(b.gravity));
}

double largestRestingGap() {
    return 1e-3;
}

std::optional<Mat3> freeTurns(const btRigidBody& body, const btTransform& frame_from_world) {
    const btVector3& factor = body.getAngularFactor();
    if (factor == btVector3(1, 1, 1)) return std::nullopt;
    const btMatrix3x3& turn = frame_from_world.getBasis();
    return fromBullet(turn.scaled(factor) * turn.transpose());
}

Mobility mobilityOf(const btCollisionObject& object, const btTransform& frame_from_world,
                    const btVector3& point) {
    Mobility mobility;
    btVector3 unused;
    btScalar inverse_mass = 0;
    if (const btRigidBody* body = btRigidBody::upcast(&object)) {
        if (!canMove(*body)) return mobility;
        const btMatrix3x3& turn = frame_from_world.getBasis();
        mobility.inverse_mass = body->getInvMass();
        mobility.centre = fromBullet(frame_from_world * body->getCenterOfMassPosition());
        mobility.inverse_inertia = fromBullet(turn * body->getInvInertiaTensorWorld() * turn.transpose());
        if (const auto free_turns = freeTurns(*body, frame_from_world))
            mobility = mobility.heldBack(*free_turns);
    } else if (linkMotion(object, point, unused, inverse_mass)) {
        if (inverse_mass > 0)
            mobility = Mobility::ofPoint(1 / inverse_mass, fromBullet(frame_from_world * point));
    }
    return mobility;
}

}  // namespace sherd
