#include "bullet/ground/ground_contact.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "bullet/ground/ground_surface.h"
#include "bullet/ground/standing_contacts.h"
#include "bullet/world/body_travel.h"
#include "bullet/world/extra_contacts.h"

namespace sherd {

namespace {

constexpr btScalar far_away = 1000;  // m; the solver does nothing about a contact of that distance
constexpr btScalar least_height = btScalar(0.25);   // of the ball's radius: clear of rounding
constexpr btScalar nearly_there = btScalar(0.999);  // of the way to a point of the ground
constexpr btScalar deepest_birth = btScalar(0.5);   // of the radius of the whole
constexpr double a_moment_s = 1;
constexpr int most_shifts = 4;  // each out of the ground where fragments are deepest in it

/// Breakables by their bodies; for look-up only.
using ByBody = std::unordered_map<const btCollisionObject*, const Breakable*>;

btVector3 ballCentre(const Breakable& fragment) {
    return fragment.body->getWorldTransform() * fragment.inner_ball.centre;
}

/// What a body may touch.
std::optional<GroundPoint> groundAround(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    return groundNear(world, body, body.getCenterOfMassPosition(), radiusAboutOrigin(body));
}

/// What leads a ball that crossed the ground back to the side that it came from: its centre as high above the
/// ground as its radius, but hardly higher than it was.
btVector3 wayBack(const GroundPoint& crossed, const btVector3& from, const btVector3& to, btScalar radius) {
    const btScalar before = (from - crossed.point).dot(crossed.normal),
                   after = (to - crossed.point).dot(crossed.normal);
    return crossed.normal * (btClamped(before, least_height * radius, radius) - after);
}

/// The velocity to be added to what is set back: on its way into the ground gravity has made it faster than
/// it was where it is set back to.
btVector3 slowedBy(const btVector3& shift, const btVector3& velocity, const btVector3& gravity) {
    const btVector3 back = shift.normalized();
    const btScalar into = -velocity.dot(back), gained = -2 * gravity.dot(shift);
    if (!(into > 0) || !(gained > 0)) return btVector3(0, 0, 0);
    return (into - btSqrt(std::max(btScalar(0), into * into - gained))) * back;
}

/// Sets bodies back as one.
void setBack(const std::vector<btRigidBody*>& bodies, const btVector3& shift) {
    btVector3 momentum(0, 0, 0), weight(0, 0, 0);
    btScalar mass = 0;
    for (const btRigidBody* body : bodies) {
        const btScalar own = 1 / body->getInvMass();
        mass += own;
        momentum += own * body->getLinearVelocity();
        weight += own * body->getGravity() * body->getLinearFactor();
    }
    const btVector3 slowed = slowedBy(shift, momentum / mass, weight / mass);
    for (btRigidBody* body : bodies) {
        body->setLinearVelocity(body->getLinearVelocity() + slowed * body->getLinearFactor());
        btTransform place = body->getWorldTransform();
        place.getOrigin() += shift;
        body->setCenterOfMassTransform(place);  // which notes the velocity for what is drawn
    }
}

/// What holds a body up that is in the ground: its ball, if that touches it, or the vertices that are in
/// it if no contact of Bullet's does. Of what is deep in the ground it may find none that are right.
void addContactsOfBall(btDiscreteDynamicsWorld& world, const Breakable& breakable, bool is_held,
                       const MovedSurfaces& moved) {
    btRigidBody& body = *breakable.body;
    const btVector3 centre = ballOnItsSide(world, breakable, moved);
    const btScalar radius = breakable.inner_ball.radius;
    if (is_held && !breakable.isFragment()) return;  // whole bodies stand as any of Bullet's
    const auto ground =
        groundNear(world, body, centre, is_held ? radius : std::max(radius, radiusAboutOrigin(body)));
    if (!ground) return;
    std::vector<Foot> feet;
    if (!is_held) feet = feetIn(*ground->ground, body, centre);
    if (feet.empty()) {
        if (ground->distance > radius) return;
        feet.push_back({centre - ground->normal * radius, ground->distance - radius, 0, 0, ground->normal});
    }
    btPersistentManifold* manifold = addExtraManifold(world, body, *ground->ground);
    if (!manifold) return;
    for (const Foot& foot : feet) {
        const btVector3 below = foot.place - foot.above * foot.normal;
        btManifoldPoint point(body.getWorldTransform().inverse() * foot.place,
                              ground->ground->getWorldTransform().inverse() * below, foot.normal, foot.above);
        point.m_positionWorldOnA = foot.place;
        point.m_positionWorldOnB = below;
        point.m_combinedFriction = gCalculateCombinedFrictionCallback(&body, ground->ground);
        manifold->addManifoldPoint(point, true);
    }
}

/// Whether a contact with a surface pushes the ball towards it, with nothing between the two. Where other
/// ground is between them, as where a ring hangs on a rod, the contact is right.
bool pushesToTheOtherSide(btDiscreteDynamicsWorld& world, const Breakable& fragment, const btVector3& push,
                          const btVector3& on_ground, const MovedSurfaces& moved) {
    const btVector3 centre = ballOnItsSide(world, fragment, moved), way = on_ground - centre;
    return push.dot(way) > 0 && !groundBetween(world, *fragment.body, centre, centre + way * nearly_there);
}

/// Returns the bodies that other contacts are left to.
std::unordered_set<const Breakable*> leaveOutWrongContacts(btDiscreteDynamicsWorld& world,
                                                           const ByBody& breakables,
                                                           const MovedSurfaces& moved) {
    std::unordered_set<const Breakable*> held;
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const bool is_b = isGroundSurface(*manifold.getBody0());
        if (!is_b && !isGroundSurface(*manifold.getBody1())) continue;
        const auto found = breakables.find(is_b ? manifold.getBody1() : manifold.getBody0());
        if (found == breakables.end()) continue;
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            btManifoldPoint& point = manifold.getContactPoint(p);
            if (!isOnTriangle(point, !is_b)) {  // of a compound that has solid parts, too
                held.insert(found->second);
                continue;
            }
            const btVector3 push = is_b ? -point.m_normalWorldOnB : point.m_normalWorldOnB;
            const btVector3 on_ground = is_b ? point.m_positionWorldOnA : point.m_positionWorldOnB;
            if (pushesToTheOtherSide(world, *found->second, push, on_ground, moved))
                point.setDistance(far_away);
            else
                held.insert(found->second);
        }
    }
    return held;
}

/// A way along that from one point to another that is seen in single precision: no ray meets the surface that
/// it ends or begins on.
btVector3 aLittle(const btVector3& from, const btVector3& to) {
    const btScalar length = (to - from).length();
    if (!(length > 0)) return btVector3(0, 0, 0);
    const btScalar rounding = 16 * SIMD_EPSILON * (to.length() + length);
    return (to - from) * (std::max(btScalar(1e-4) * length, rounding) / length);
}

void stopAtGround(btDiscreteDynamicsWorld& world, const Breakable& fragment, const MovedSurfaces& moved) {
    const InnerBall& ball = fragment.inner_ball;
    const btVector3 start = fragment.way.from * ball.centre, to = ballCentre(fragment);
    const auto crossed = groundCrossed(world, *fragment.body, start, to + aLittle(start, to), moved);
    if (!crossed) return;
    const btTransform went = moveOf(crossed, moved);
    const btVector3 from = went * start;
    const btVector3 back = wayBack(*crossed, from, to, ball.radius);
    if (!groundCrossed(world, *fragment.body, start, to + back, moved)) return setBack({fragment.body}, back);
    // It is between two walls and stays where it was, or goes with the one that moves. With its speed it
    // would get faster there from step to step.
    const btTransform place = went * fragment.way.from;
    fragment.body->setCenterOfMassTransform(place);
    fragment.body->setLinearVelocity((place.getOrigin() - fragment.way.from.getOrigin()) /
                                     world.getSolverInfo().m_timeStep);
    fragment.body->setAngularVelocity(btVector3(0, 0, 0));
}

/// The last ground on the way from a point that is on its right side, if the end of the way is on the wrong
/// one: beyond an odd number of surfaces.
std::optional<GroundPoint> groundBefore(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                        const btVector3& right, const btVector3& to) {
    constexpr int most_surfaces = 16;
    if (!((to - right).length2() > 0)) return std::nullopt;
    const btVector3 clear = aLittle(right, to);  // the next ray must not find the same surface
    std::optional<GroundPoint> last;
    btVector3 from = right;
    for (int count = 0; count < most_surfaces; ++count) {
        const auto next = groundBetween(world, body, from, to);
        if (!next) return count % 2 == 1 ? last : std::nullopt;
        last = next;
        from = next->point + clear;
    }
    return std::nullopt;
}

/// Where a fragment was as a part of the whole, when that stood elsewhere.
btVector3 ballCentreBefore(const Breakable& whole, const Breakable& fragment, const btTransform& stood) {
    return stood * whole.body->getWorldTransform().inverse() * ballCentre(fragment);
}

/// What tells on which side of the ground a body was that breaks.
struct Past {
    btTransform went;  // of the ground around it, since what is known of its way
    btVector3 right;   // a point on its side
};

/// What sets a fragment back that is beyond the ground. What was clear of all ground a moment ago came from
/// there; else the last step tells, or the ball of what it was part of.
btVector3 wayBackAtBirth(btDiscreteDynamicsWorld& world, const Breakable& whole, const Breakable& fragment,
                         const btVector3& shift, const Past& past) {
    const btRigidBody& body = *whole.body;
    const btVector3 to = ballCentre(fragment) + shift;
    const btScalar radius = fragment.inner_ball.radius;
    if (whole.way.since_clear_s < a_moment_s) {
        const btVector3 from = ballCentreBefore(whole, fragment, past.went * whole.way.clear_at);
        const auto crossed = groundBefore(world, body, from, to);
        const btVector3 back = crossed ? wayBack(*crossed, from, to, radius) : btVector3(0, 0, 0);
        // Further away is ground that it went around.
        return back.length() < 2 * radiusAboutOrigin(body) ? back : btVector3(0, 0, 0);
    }
    const btTransform came_from = past.went * whole.way.from;
    const btVector3 before = ballCentreBefore(whole, fragment, came_from);
    if (!groundBetween(world, body, came_from * whole.inner_ball.centre, before))
        if (const auto crossed = groundBetween(world, body, before, to))
            return wayBack(*crossed, before, to, radius);
    if (const auto crossed = groundBefore(world, body, past.right, to)) {
        const btVector3 back = wayBack(*crossed, past.right, to, radius);
        // What stands astride of a wall without an inside is on both sides of it by right.
        const bool is_astride = back.length() > deepest_birth * radiusAboutOrigin(body);
        if (!is_astride) return back;
    }
    return btVector3(0, 0, 0);
}

/// Notes where a body is while no ground is near it. What is known of its way goes along with ground that
/// moved.
void noteIfClear(btDiscreteDynamicsWorld& world, Breakable& breakable, double time_step_s,
                 const MovedSurfaces& moved) {
    const btRigidBody& body = *breakable.body;
    if (const auto ground = groundAround(world, body)) {
        breakable.way.since_clear_s += time_step_s;
        const btTransform went = moveOf(ground, moved);
        breakable.way.clear_at = went * breakable.way.clear_at;
        breakable.way.from = went * breakable.way.from;
        return;
    }
    breakable.way.since_clear_s = 0;
    breakable.way.clear_at = body.getWorldTransform();
}

}  // namespace

btVector3 ballOnItsSide(btDiscreteDynamicsWorld& world, const Breakable& breakable,
                        const MovedSurfaces& moved) {
    const btVector3 centre = ballCentre(breakable);
    const bool stood = breakable.way.isAt(breakable.body->getWorldTransform());
    return stood ? onItsSide(world, *breakable.body, centre, moved) : centre;
}

void setBackOnGround(btDiscreteDynamicsWorld& world, const Breakable& whole,
                     const std::vector<std::unique_ptr<Breakable>>& fragments, const MovedSurfaces& moved) {
    if (!whole.way.is_known) return;
    // Bullet's solver moves what is deep in the ground a little, perhaps to its other side; what is further
    // away the app has put there.
    const btScalar radius = radiusAboutOrigin(*whole.body);
    if (travel(whole.way.to, whole.body->getWorldTransform(), radius) > deepest_birth * radius) return;
    std::vector<btRigidBody*> bodies;
    for (const auto& fragment : fragments) {
        if (!fragment->isDynamic()) return;  // what is held stays where it is, and what it carries with it
        bodies.push_back(fragment->body);
    }
    const Past past{
        moved.empty() ? btTransform::getIdentity() : moveOf(groundAround(world, *whole.body), moved),
        onItsSide(world, *whole.body, whole.way.to * whole.inner_ball.centre, moved)};
    btVector3 shift(0, 0, 0);
    for (int round = 0; round < most_shifts; ++round) {
        btVector3 furthest(0, 0, 0);
        for (const auto& fragment : fragments) {
            const btVector3 back = wayBackAtBirth(world, whole, *fragment, shift, past);
            if (back.length2() > furthest.length2()) furthest = back;
        }
        if (furthest.isZero()) break;
        shift += furthest;
    }
    if (!shift.isZero()) setBack(bodies, shift);
}

void addGroundContacts(btDiscreteDynamicsWorld& world, const std::vector<const Breakable*>& bodies,
                       const MovedSurfaces& moved) {
    if (!hasGroundSurface(world)) return;
    ByBody moving;
    for (const Breakable* body : bodies)
        if (body->isDynamic() && body->body->isActive()) moving.emplace(body->body, body);
    if (moving.empty()) return;
    const auto held = leaveOutWrongContacts(world, moving, moved);
    for (const Breakable* body : bodies)
        if (moving.count(body->body)) addContactsOfBall(world, *body, held.count(body) > 0, moved);
}

void stopAtGround(btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                  const StepSnapshot& before, MovedGround& moved_ground) {
    if (!hasGroundSurface(world)) {
        for (const auto& breakable : breakables.all())
            if (breakable->way.is_known) breakable->way = {};
        moved_ground.endStep(world);
        return;
    }
    static const MovedSurfaces& none = *new MovedSurfaces;  // never destroyed, as worlds may end last
    for (const auto& breakable : breakables.all()) {
        const BodyState* start = breakable->in_world ? before.find(breakable->body) : nullptr;
        if (!start) continue;
        const MovedSurfaces& moved = breakable->way.isAt(start->transform) ? moved_ground.surfaces() : none;
        breakable->way.is_known = true;
        breakable->way.from = start->transform;
        if (breakable->isDynamic()) {
            stopAtGround(world, *breakable, moved);
            noteIfClear(world, *breakable, world.getSolverInfo().m_timeStep, moved);
        }
        breakable->way.to = breakable->body->getWorldTransform();
    }
    moved_ground.endStep(world);
}

}  // namespace sherd
