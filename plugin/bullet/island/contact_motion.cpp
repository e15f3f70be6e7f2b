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
        motion.spin = state ? state->angular : body->getAngularVelocity();
        motion.arm = point - (state ? state->transform : body->getWorldTransform()).getOrigin();
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

namespace {

/// How far a point on a turning body is along a direction from where its velocity alone would have it, and
/// how much faster.
struct Bend {
    double way_m = 0, speed_m_s = 0;
};

Bend bendOf(const PointMotion& motion, const btVector3& direction, double time_s) {
    const btScalar spin = motion.spin.length();
    const btScalar angle = spin * btScalar(time_s);
    if (!(btFabs(angle) > 0)) return {};
    const btVector3 turned = motion.arm.rotate(motion.spin / spin, angle);
    const btVector3 straight = motion.spin.cross(motion.arm);
    return {direction.dot(turned - motion.arm - btScalar(time_s) * straight),
            direction.dot(motion.spin.cross(turned) - straight)};
}

}  // namespace

TouchOfPoints touchOf(const PointMotion& pushed, const PointMotion& other, const btVector3& normal,
                      double depth_m, double time_step_s) {
    const double closing = (other.velocity - pushed.velocity).dot(normal);
    const double gravity = other.fall - pushed.fall;
    const TouchOfPoints touch{timeSinceTouch(closing, depth_m, time_step_s),
                              speedOfTouch(closing, gravity, depth_m, time_step_s), false};
    constexpr double hardly = 0.02;  // of the closing speed
    const double bends_m_s2 =
        pushed.spin.length2() * pushed.arm.length() + other.spin.length2() * other.arm.length();
    if (!(bends_m_s2 * time_step_s > hardly * closing)) return touch;
    const double now = closing + gravity * time_step_s / 2;
    const auto bendAt = [&](double time_s) {
        const Bend a = bendOf(pushed, normal, time_s), b = bendOf(other, normal, time_s);
        return Bend{b.way_m - a.way_m, b.speed_m_s - a.speed_m_s};
    };
    // Newton's method for the time at which the depth is zero.
    constexpr int most_rounds = 12;
    constexpr double exact = 1e-6;  // of a step
    double time_s = -touch.ago_s, speed = now;
    for (int round = 0; round < most_rounds; ++round) {
        const Bend bend = bendAt(time_s);
        const double depth = depth_m + time_s * (now + gravity * time_s / 2) + bend.way_m;
        speed = now + gravity * time_s + bend.speed_m_s;
        if (!(speed > 0)) break;
        const double next_s = std::clamp(time_s - depth / speed, -time_step_s, time_step_s);
        const bool is_there = std::abs(next_s - time_s) < exact * time_step_s;
        time_s = next_s;
        if (is_there) break;
    }
    return {-time_s, std::max(speed, 0.0), true};
}

double slowestStrike(const PointMotion& a, const PointMotion& b, double time_step_s) {
    constexpr double resting_steps = 2;
    return resting_steps * time_step_s * std::max(std::abs(a.gravity), std::abs(b.gravity));
}

bool isSetDown(const btCollisionObject& heavy, const btCollisionObject& body, double closing_m_s,
               double depth_m, double slowest_m_s, double time_step_s) {
    constexpr btScalar times_as_heavy = 3;
    constexpr double of_slowest = 0.6;  // two steps of fall: what was put down with a gap falls for one
    constexpr double apart_m = 3e-4;    // what rests rubs by less
    if (!(closing_m_s > of_slowest * slowest_m_s)) return false;
    if (!(closing_m_s * time_step_s - depth_m > apart_m)) return false;
    if (!givesWay(heavy) || !givesWay(body)) return false;
    return times_as_heavy * btRigidBody::upcast(&heavy)->getInvMass() <=
           btRigidBody::upcast(&body)->getInvMass();
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
