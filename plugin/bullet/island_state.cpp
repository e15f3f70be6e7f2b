#include "bullet/island_state.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>

#include "bullet/multi_body_state.h"

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

}  // namespace

void StepSnapshot::take(btDiscreteDynamicsWorld& world) {
    bodies_.clear();
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        BodyState state;
        state.object = objects[i];
        state.transform = objects[i]->getWorldTransform();
        if (const btRigidBody* body = btRigidBody::upcast(objects[i])) {
            state.linear = body->getLinearVelocity();
            state.angular = body->getAngularVelocity();
        }
        bodies_.push_back(state);
    }
    manifolds_.clear();
    points_.clear();
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
        manifolds_.push_back({manifold, points_.size(), manifold->getNumContacts()});
        for (int p = 0; p < manifold->getNumContacts(); ++p) {
            const btManifoldPoint& point = manifold->getContactPoint(p);
            points_.push_back(
                {point.m_appliedImpulse, point.m_appliedImpulseLateral1, point.m_appliedImpulseLateral2});
        }
    }
    constraints_.clear();
    for (int i = 0; i < world.getNumConstraints(); ++i) {
        btTypedConstraint* constraint = world.getConstraint(i);
        constraints_.push_back(
            {constraint, constraint->isEnabled(), constraint->internalGetAppliedImpulse()});
    }
}

const BodyState* StepSnapshot::find(const btCollisionObject* object) const {
    return lookUp(bodies_, object->getWorldArrayIndex(),
                  [&](const BodyState& state) { return state.object == object; });
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
        return entry.manifold == &manifold;
    });
    if (!state) return;
    for (int p = 0; p < std::min(state->point_count, manifold.getNumContacts()); ++p) {
        const PointImpulses& impulses = points_[state->first_point + p];
        btManifoldPoint& point = manifold.getContactPoint(p);
        point.m_appliedImpulse = impulses.normal;
        point.m_appliedImpulseLateral1 = impulses.lateral_1;
        point.m_appliedImpulseLateral2 = impulses.lateral_2;
    }
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
