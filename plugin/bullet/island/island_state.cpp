#include "bullet/island/island_state.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>

#include "bullet/island/multi_body_state.h"

namespace sherd {

namespace {

/// Finds an entry of a copy of one of Bullet's arrays by the index that the original knows. Removals from
/// Bullet's array move single entries, so the index is still right for nearly all; the others are searched
/// for.
template <class Entry, class Same>
const Entry* lookUp(const std::vector<Entry>& entries, int likely_index, const Same& same) {
    const bool in_range = likely_index >= 0 && likely_index < static_cast<int>(entries.size());
    if (in_range && same(entries[likely_index])) return &entries[likely_index];
    const auto found = std::find_if(entries.begin(), entries.end(), same);
    return found == entries.end() ? nullptr : &*found;
}

/// Without the fourth number, which may be anything.
bool samePlace(const btVector3& a, const btVector3& b) {
    return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
}

}  // namespace

void StepSnapshot::clear() {
    bodies_.clear();
    proxies_.clear();
    manifolds_.clear();
    points_.clear();
    constraints_.clear();
}

void StepSnapshot::takeBodies(const btDiscreteDynamicsWorld& world) {
    clear();
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) addBody(*objects[i]);
}

void StepSnapshot::take(btDiscreteDynamicsWorld& world) {
    takeBodies(world);
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
        manifolds_.push_back({manifold, manifold->getBody0(), manifold->getBody1(), points_.size(),
                              manifold->getNumContacts()});
        for (int p = 0; p < manifold->getNumContacts(); ++p) {
            const btManifoldPoint& point = manifold->getContactPoint(p);
            points_.push_back({point.m_localPointA, point.m_localPointB, point.m_appliedImpulse,
                               point.m_appliedImpulseLateral1, point.m_appliedImpulseLateral2});
        }
    }
    for (int i = 0; i < world.getNumConstraints(); ++i) {
        btTypedConstraint* constraint = world.getConstraint(i);
        constraints_.push_back(
            {constraint, constraint->isEnabled(), constraint->internalGetAppliedImpulse()});
    }
}

void StepSnapshot::add(const std::vector<btCollisionObject*>& objects) {
    for (const btCollisionObject* object : objects) addBody(*object);
}

void StepSnapshot::addBody(const btCollisionObject& object) {
    BodyState state;
    state.object = &object;
    state.transform = object.getWorldTransform();
    if (const btRigidBody* body = btRigidBody::upcast(&object)) {
        state.linear = body->getLinearVelocity();
        state.angular = body->getAngularVelocity();
    }
    bodies_.push_back(state);
    proxies_.push_back(object.getBroadphaseHandle()->m_uniqueId);
}

const BodyState* StepSnapshot::find(const btCollisionObject* object) const {
    const BodyState* state = lookUp(bodies_, object->getWorldArrayIndex(),
                                    [&](const BodyState& entry) { return entry.object == object; });
    const btBroadphaseProxy* proxy = object->getBroadphaseHandle();
    const bool same = state && proxy && proxies_[state - bodies_.data()] == proxy->m_uniqueId;
    return same ? state : nullptr;
}

void StepSnapshot::restore(const Island& island) const {
    for (btCollisionObject* object : island.bodies) {
        btRigidBody* body = btRigidBody::upcast(object);
        const BodyState* state = body ? find(object) : nullptr;
        if (!state) continue;
        body->setLinearVelocity(state->linear);
        body->setAngularVelocity(state->angular);
        body->setWorldTransform(state->transform);
    }
    for (btPersistentManifold* manifold : island.manifolds) restorePoints(*manifold);
    for (btTypedConstraint* constraint : island.constraints) restoreConstraint(*constraint);
    for (btMultiBody* multi_body : island.multi_bodies) dropPendingVelocity(*multi_body);
}

void StepSnapshot::restorePoints(btPersistentManifold& manifold) const {
    const ManifoldState* state = lookUp(manifolds_, manifold.m_index1a, [&](const ManifoldState& entry) {
        return entry.manifold == &manifold && entry.body_a == manifold.getBody0() &&
               entry.body_b == manifold.getBody1();
    });
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        btManifoldPoint& point = manifold.getContactPoint(p);
        const PointImpulses* known = state ? find(*state, p, point) : nullptr;
        const PointImpulses impulses = known ? *known : PointImpulses{};
        point.m_appliedImpulse = impulses.normal;
        point.m_appliedImpulseLateral1 = impulses.lateral_1;
        point.m_appliedImpulseLateral2 = impulses.lateral_2;
    }
}

const StepSnapshot::PointImpulses* StepSnapshot::find(const ManifoldState& state, int likely_place,
                                                      const btManifoldPoint& point) const {
    for (int i = 0; i < state.point_count; ++i) {
        const PointImpulses& entry = points_[state.first_point + (likely_place + i) % state.point_count];
        if (samePlace(entry.local_a, point.m_localPointA) && samePlace(entry.local_b, point.m_localPointB))
            return &entry;
    }
    return nullptr;
}

void StepSnapshot::restoreConstraint(btTypedConstraint& constraint) const {
    const auto state =
        std::find_if(constraints_.begin(), constraints_.end(),
                     [&](const ConstraintState& entry) { return entry.constraint == &constraint; });
    if (state == constraints_.end()) return;
    constraint.setEnabled(state->enabled);
    constraint.internalSetAppliedImpulse(state->applied_impulse);
}

}  // namespace sherd
