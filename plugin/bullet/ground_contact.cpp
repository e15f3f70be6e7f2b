#include "bullet/ground_contact.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <unordered_map>

#include "bullet/extra_contacts.h"
#include "bullet/ground_surface.h"

namespace sherd {

namespace {

constexpr btScalar far_away = 1000;  // m; the solver does nothing about a contact of that distance
constexpr btScalar least_height = btScalar(0.25);   // of the ball's radius: clear of rounding
constexpr btScalar nearly_there = btScalar(0.999);  // of the way to a point of the ground
constexpr int most_shifts = 4;  // each out of the ground where fragments are deepest in it

/// Fragments by their bodies; for look-up only.
using ByBody = std::unordered_map<const btCollisionObject*, const Breakable*>;

btVector3 ballCentre(const Breakable& fragment) {
    return fragment.body->getWorldTransform() * fragment.inner_ball.centre;
}

/// What leads a ball that crossed the ground back to the side that it came from: its centre as high above the
/// ground as its radius, but hardly higher than it was.
btVector3 wayBack(const GroundPoint& crossed, const btVector3& from, const btVector3& to, btScalar radius) {
    const btScalar before = (from - crossed.point).dot(crossed.normal),
                   after = (to - crossed.point).dot(crossed.normal);
    return crossed.normal * (btClamped(before, least_height * radius, radius) - after);
}

void shiftBy(btRigidBody& body, const btVector3& shift) {
    btTransform place = body.getWorldTransform();
    place.getOrigin() += shift;
    body.setCenterOfMassTransform(place);
}

void addBallContact(btDiscreteDynamicsWorld& world, const Breakable& fragment) {
    btRigidBody& body = *fragment.body;
    const btScalar radius = fragment.inner_ball.radius;
    const auto ground = groundNear(world, body, ballCentre(fragment), radius);
    if (!ground) return;
    const btVector3 lowest = ballCentre(fragment) - ground->normal * radius;
    btManifoldPoint point(body.getWorldTransform().inverse() * lowest,
                          ground->ground->getWorldTransform().inverse() * ground->point, ground->normal,
                          ground->distance - radius);
    point.m_positionWorldOnA = lowest;
    point.m_positionWorldOnB = ground->point;
    point.m_combinedFriction = gCalculateCombinedFrictionCallback(&body, ground->ground);
    addExtraManifold(world, body, *ground->ground).addManifoldPoint(point, true);
}

/// Whether a contact with a surface pushes the ball towards it, with nothing between the two. Where other
/// ground is between them, as where a ring hangs on a rod, the contact is right.
bool pushesToTheOtherSide(btDiscreteDynamicsWorld& world, const Breakable& fragment, const btVector3& push,
                          const btVector3& on_ground) {
    const btVector3 centre = ballCentre(fragment), way = on_ground - centre;
    return push.dot(way) > 0 && !groundBetween(world, *fragment.body, centre, centre + way * nearly_there);
}

void leaveOutWrongContacts(btDiscreteDynamicsWorld& world, const ByBody& fragments) {
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const bool is_b = isGroundSurface(*manifold.getBody0());
        if (!is_b && !isGroundSurface(*manifold.getBody1())) continue;
        const auto fragment = fragments.find(is_b ? manifold.getBody1() : manifold.getBody0());
        if (fragment == fragments.end()) continue;
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            btManifoldPoint& point = manifold.getContactPoint(p);
            const btVector3 push = is_b ? -point.m_normalWorldOnB : point.m_normalWorldOnB;
            const btVector3 on_ground = is_b ? point.m_positionWorldOnA : point.m_positionWorldOnB;
            if (pushesToTheOtherSide(world, *fragment->second, push, on_ground)) point.setDistance(far_away);
        }
    }
}

void stopAtGround(btDiscreteDynamicsWorld& world, const Breakable& fragment) {
    const InnerBall& ball = fragment.inner_ball;
    const btVector3 from = fragment.moved_from * ball.centre, to = ballCentre(fragment);
    const auto crossed = groundBetween(world, *fragment.body, from, to);
    if (!crossed) return;
    const btVector3 back = wayBack(*crossed, from, to, ball.radius);
    if (groundBetween(world, *fragment.body, from, to + back))  // it is between two walls
        fragment.body->setCenterOfMassTransform(fragment.moved_from);
    else
        shiftBy(*fragment.body, back);
}

}  // namespace

void setBackOnGround(btDiscreteDynamicsWorld& world, const Breakable& whole,
                     const std::vector<std::unique_ptr<Breakable>>& fragments) {
    if (!(whole.body->getWorldTransform() == whole.moved_to)) return;  // the app has put it elsewhere
    for (const auto& fragment : fragments)
        if (!fragment->isDynamic()) return;  // what is held stays where it is, and what it carries with it
    const btTransform back_in_time = whole.moved_from * whole.moved_to.inverse();
    btVector3 shift(0, 0, 0);
    for (int round = 0; round < most_shifts; ++round) {
        btVector3 furthest(0, 0, 0);
        for (const auto& fragment : fragments) {
            const btVector3 centre = ballCentre(*fragment), from = back_in_time * centre, to = centre + shift;
            const auto crossed = groundBetween(world, *whole.body, from, to);
            if (!crossed) continue;
            const btVector3 back = wayBack(*crossed, from, to, fragment->inner_ball.radius);
            if (back.length2() > furthest.length2()) furthest = back;
        }
        if (furthest.isZero()) break;
        shift += furthest;
    }
    if (shift.isZero()) return;
    for (const auto& fragment : fragments) shiftBy(*fragment->body, shift);
}

void addGroundContacts(btDiscreteDynamicsWorld& world, const std::vector<const Breakable*>& fragments) {
    ByBody moving;
    for (const Breakable* fragment : fragments)
        if (fragment->isDynamic() && fragment->body->isActive()) moving.emplace(fragment->body, fragment);
    if (moving.empty() || !hasGroundSurface(world)) return;
    leaveOutWrongContacts(world, moving);
    for (const Breakable* fragment : fragments)
        if (moving.count(fragment->body)) addBallContact(world, *fragment);
}

void stopAtGround(btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                  const StepSnapshot& before) {
    const bool has_ground = hasGroundSurface(world);
    for (const auto& breakable : breakables.all()) {
        const BodyState* start = breakable->in_world ? before.find(breakable->body) : nullptr;
        if (!start) continue;
        breakable->moved_from = start->transform;
        if (has_ground && breakable->isFragment() && breakable->isDynamic()) stopAtGround(world, *breakable);
        breakable->moved_to = breakable->body->getWorldTransform();
    }
}

}  // namespace sherd
