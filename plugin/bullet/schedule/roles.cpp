#include "bullet/schedule/roles.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "bullet/bodies/decided_blow.h"
#include "bullet/island/contact_motion.h"
#include "bullet/world/body_travel.h"
#include "bullet/world/objects_around.h"
#include "bullet/world/pair_filter.h"
#include "bullet/world/world_internals.h"

namespace sherd {

namespace {

constexpr std::size_t most_met = 4, most_roles = 16, most_with_supports = 32;
constexpr double disturbing = 0.25;  // of a mover's mass: what touches it turns it aside

using Objects = std::vector<const btCollisionObject*>;
using ObjectSet = std::unordered_set<const btCollisionObject*>;  // in no order: see inOrder

/// Whether a stand-in does what the object does: of links of multi-bodies and soft bodies none would.
bool canStandIn(const btCollisionObject& object) {
    const bool is_rigid = btRigidBody::upcast(&object) != nullptr;
    return object.hasContactResponse() &&
           (is_rigid ||
            (object.getInternalType() == btCollisionObject::CO_COLLISION_OBJECT && object.isStaticObject()));
}

/// The breakable body that an object is, if `energy_j` may break it and that could be foreseen.
const Breakable* breakableBy(double energy_j, const btCollisionObject& object,
                             const BreakableRegistry& breakables, double time_s) {
    const Breakable* breakable = breakables.of(object);
    const bool may_break =
        breakable && isForeseeable(*breakable, time_s) && energy_j >= breakable->least_energy_j;
    return may_break ? breakable : nullptr;
}

/// Where a body may be within some time, as a box.
void sweptBox(const btRigidBody& body, double ahead_s, btVector3& low, btVector3& high) {
    body.getAabb(low, high);
    const auto t = static_cast<btScalar>(ahead_s);
    const btVector3 way = body.getLinearVelocity() * t, fall = body.getGravity() * (t * t / 2);
    btVector3 furthest_low = low, furthest_high = high;
    for (const btVector3& shift : {way, btVector3(way + fall)}) {
        furthest_low.setMin(low + shift);
        furthest_high.setMax(high + shift);
    }
    low = furthest_low;
    high = furthest_high;
}

/// Whether a straight way, which the ball around a body goes, leads through the box of another one.
bool isOnTheWay(const btRigidBody& body, const btCollisionObject& other, double ahead_s) {
    btVector3 centre;
    btScalar radius;
    body.getCollisionShape()->getBoundingSphere(centre, radius);
    const btBroadphaseProxy& proxy = *other.getBroadphaseHandle();
    const btVector3 margin(radius, radius, radius), low = proxy.m_aabbMin - margin,
                                                    high = proxy.m_aabbMax + margin;
    const btVector3 from = body.getWorldTransform() * centre,
                    to = from + body.getLinearVelocity() * static_cast<btScalar>(ahead_s);
    btScalar part = 1;
    btVector3 normal;
    return TestPointAgainstAabb2(low, high, from) || btRayAabb(from, to, low, high, part, normal);
}

/// What a body brings to what stands still, J, and somewhat more: gravity goes on pulling.
double energyOf(const btRigidBody& mover) {
    const double speed =
        mover.getLinearVelocity().length() + radiusAboutOrigin(mover) * mover.getAngularVelocity().length();
    return speed * speed / mover.getInvMass();
}

/// What a body does by itself, from its last step; as gravity has it where something touches it.
Role roleOf(const btCollisionObject& object, const BreakableRegistry& breakables, const StepSnapshot& before,
            btScalar time_step_s, bool is_touched) {
    Role role;
    role.object = &object;
    role.breakable = breakables.of(object);
    const btRigidBody* body = btRigidBody::upcast(&object);
    const BodyState* state = body && canMove(*body) && !is_touched ? before.find(body) : nullptr;
    if (!state || !body->isActive()) return role;
    const btVector3 acceleration = (body->getLinearVelocity() - state->linear) / time_step_s;
    const btScalar off = (acceleration - body->getGravity()).length();
    if (off > btScalar(0.01) * (1 + body->getGravity().length())) role.driven = acceleration;
    return role;
}

/// How far the boxes of two bodies are apart, squared.
btScalar gapBetween(const btCollisionObject& a, const btCollisionObject& b) {
    const btBroadphaseProxy &box_a = *a.getBroadphaseHandle(), &box_b = *b.getBroadphaseHandle();
    btVector3 gap = box_a.m_aabbMin - box_b.m_aabbMax;
    gap.setMax(box_b.m_aabbMin - box_a.m_aabbMax);
    gap.setMax(btVector3(0, 0, 0));
    return gap.length2();
}

/// What a body may meet on its way.
Objects metBy(btDiscreteDynamicsWorld& world, const btRigidBody& mover, double ahead_s) {
    btVector3 low, high;
    sweptBox(mover, ahead_s, low, high);
    Objects met;
    for (const btCollisionObject* object : objectsAround(world, low, high))
        if (object != &mover && canStandIn(*object) && mayMeet(world, mover, *object) &&
            isOnTheWay(mover, *object, ahead_s))
            met.push_back(object);
    return met;
}

/// When the boxes of two bodies meet if both go on as they do, s; infinity: never.
btScalar meetAfter_s(const btRigidBody& mover, const btCollisionObject& other) {
    constexpr btScalar never = std::numeric_limits<btScalar>::infinity();
    const btBroadphaseProxy &own = *mover.getBroadphaseHandle(), &box = *other.getBroadphaseHandle();
    const btRigidBody* body = btRigidBody::upcast(&other);
    const btVector3 others = body ? body->getLinearVelocity() : btVector3(0, 0, 0);
    const btVector3 velocity = mover.getLinearVelocity() - others;
    btScalar first_s = 0, last_s = never;
    for (int axis = 0; axis < 3; ++axis) {
        const btScalar speed = std::abs(velocity[axis]);
        const bool is_forward = velocity[axis] > 0;
        const btScalar way = is_forward ? box.m_aabbMin[axis] - own.m_aabbMax[axis]
                                        : own.m_aabbMin[axis] - box.m_aabbMax[axis];
        const btScalar through = is_forward ? box.m_aabbMax[axis] - own.m_aabbMin[axis]
                                            : own.m_aabbMax[axis] - box.m_aabbMin[axis];
        if (way > 0) first_s = std::max(first_s, speed > 0 ? way / speed : never);
        if (through < 0) return never;
        if (speed > 0) last_s = std::min(last_s, through / speed);
    }
    return first_s <= last_s ? first_s : never;
}

/// What is met first: what flies beside the mover may be nearer than what it flies at. Of what is met at once
/// the nearest, then those that stand first among the world's objects.
void keepFirst(const btRigidBody& mover, Objects& met) {
    const auto order = [&](const btCollisionObject* object) {
        return std::make_tuple(meetAfter_s(mover, *object), gapBetween(mover, *object),
                               object->getWorldArrayIndex());
    };
    std::sort(met.begin(), met.end(),
              [&](const btCollisionObject* a, const btCollisionObject* b) { return order(a) < order(b); });
    if (met.size() > most_met) met.resize(most_met);
}

/// Whether a contact leaves open where a mover goes: it may break by it, or is turned aside.
bool disturbs(const btCollisionObject& other, const btRigidBody& mover, const BreakableRegistry& breakables) {
    if (breakables.of(mover)) return true;
    const btRigidBody* body = btRigidBody::upcast(&other);
    return !other.isStaticOrKinematicObject() && body && disturbing * body->getInvMass() < mover.getInvMass();
}

/// Objects in the order in which they stand in their world.
Objects inOrder(const ObjectSet& set) {
    Objects objects(set.begin(), set.end());
    std::sort(objects.begin(), objects.end(), [](const btCollisionObject* a, const btCollisionObject* b) {
        return a->getWorldArrayIndex() < b->getWorldArrayIndex();
    });
    return objects;
}

/// Adds what touches one of the objects.
void addNeighbours(const Touching& touching, ObjectSet& cast) {
    for (const btCollisionObject* own : inOrder(cast)) {
        if (own->isStaticObject()) continue;
        for (const btCollisionObject* other : touching.of(*own))
            if (cast.size() < most_roles && canStandIn(*other)) cast.insert(other);
    }
}

bool isBelow(const btCollisionObject& object, const btRigidBody& body) {
    const btBroadphaseProxy &box = *object.getBroadphaseHandle(), &own = *body.getBroadphaseHandle();
    const btVector3 way = (box.m_aabbMin + box.m_aabbMax - own.m_aabbMin - own.m_aabbMax) / 2;
    return object.isStaticOrKinematicObject() || way.dot(body.getGravity()) > 0;
}

/// Adds what bodies stand on, and what that stands on: without it they would fall.
void addSupports(const Touching& touching, ObjectSet& cast) {
    Objects added = inOrder(cast);
    while (!added.empty()) {
        Objects next;
        for (const btCollisionObject* own : added) {
            const btRigidBody* body = btRigidBody::upcast(own);
            if (!body || body->isStaticOrKinematicObject()) continue;
            for (const btCollisionObject* other : touching.of(*own))
                if (cast.size() < most_with_supports && canStandIn(*other) && isBelow(*other, *body) &&
                    cast.insert(other).second)
                    next.push_back(other);
        }
        added = std::move(next);
    }
}

}  // namespace

Touching::Touching(const btDiscreteDynamicsWorld& world) {
    const auto& objects = world.getCollisionObjectArray();
    of_.resize(static_cast<std::size_t>(objects.size()));
    // Predictive manifolds outlive bodies that the app takes out: those are not to be asked for their place.
    std::unordered_map<const btCollisionObject*, std::size_t> places;  // for look-up only
    for (int i = 0; i < objects.size(); ++i) places[objects[i]] = static_cast<std::size_t>(i);
    const btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold =
            *const_cast<btDispatcher&>(dispatcher).getManifoldByIndexInternal(i);
        const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
        const auto at_a = places.find(a), at_b = places.find(b);
        if (manifold.getNumContacts() == 0 || at_a == places.end() || at_b == places.end()) continue;
        of_[at_a->second].push_back(b);
        of_[at_b->second].push_back(a);
    }
}

const std::vector<const btCollisionObject*>& Touching::of(const btCollisionObject& object) const {
    return of_[static_cast<std::size_t>(object.getWorldArrayIndex())];
}

std::vector<btRigidBody*> fastBodies(const btDiscreteDynamicsWorld& world) {
    constexpr btScalar slow_m_s = btScalar(0.2), slow_rad_s = 1;
    std::vector<btRigidBody*> fast;
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        if (!objects[i]->isActive() || objects[i]->isStaticOrKinematicObject()) continue;
        btRigidBody* body = btRigidBody::upcast(objects[i]);
        if (body &&
            (body->getLinearVelocity().length2() > slow_m_s * slow_m_s ||
             body->getAngularVelocity().length2() > slow_rad_s * slow_rad_s) &&
            canMove(*body) && body->getNumConstraintRefs() == 0)
            fast.push_back(body);
    }
    return fast;
}

bool mayBring(const btRigidBody& mover, double energy_j) {
    return energyOf(mover) >= energy_j;
}

bool isForeseeable(const Breakable& breakable, double time_s) {
    const BreakableSolid& solid = *breakable.asset.solid();
    // Of other fragments a blow may leave the factor to the next one, which must not depend on what is
    // foreseen.
    const bool is_answered = !solid.isFragment() || solid.reducedStress() || solid.expectsFactor();
    return breakable.in_world && is_answered && breakable.canBeStruck() &&
           breakable.body->getNumConstraintRefs() == 0 && breakable.breaksAt(time_s) &&
           mayRunElsewhere(solid, *breakable.fracture);
}

std::vector<const Breakable*> breakablesAround(btDiscreteDynamicsWorld& world,
                                               const BreakableRegistry& breakables, const btRigidBody& mover,
                                               double ahead_s, double time_s) {
    const double energy_j = energyOf(mover);
    Objects met = metBy(world, mover, ahead_s);
    if (!met.empty()) met.push_back(&mover);
    std::vector<const Breakable*> found;
    for (const btCollisionObject* object : met)
        if (const Breakable* breakable = breakableBy(energy_j, *object, breakables, time_s))
            found.push_back(breakable);
    return found;
}

std::vector<Role> rolesAround(btDiscreteDynamicsWorld& world, const Touching& touching,
                              const BreakableRegistry& breakables, const StepSnapshot& before,
                              const btRigidBody& mover, double ahead_s, double time_s) {
    const Objects& at_mover = touching.of(mover);
    const auto turnsAside = [&](const auto* other) { return disturbs(*other, mover, breakables); };
    if (std::any_of(at_mover.begin(), at_mover.end(), turnsAside)) return {};
    const double energy_j = energyOf(mover);
    const auto mayBreak = [&](const btCollisionObject& struck) {
        return breakableBy(energy_j, struck, breakables, time_s) != nullptr;
    };
    Objects met = metBy(world, mover, ahead_s);
    const bool is_worth_it =
        mayBreak(mover)
            ? !met.empty()
            : std::any_of(met.begin(), met.end(), [&](const auto* other) { return mayBreak(*other); });
    if (!is_worth_it) return {};
    keepFirst(mover, met);
    ObjectSet cast(met.begin(), met.end());
    cast.insert(&mover);
    addNeighbours(touching, cast);
    addSupports(touching, cast);
    std::vector<Role> roles;
    for (const btCollisionObject* object : inOrder(cast))
        roles.push_back(roleOf(*object, breakables, before, world.getSolverInfo().m_timeStep,
                               !touching.of(*object).empty()));
    return roles;
}

}  // namespace sherd
