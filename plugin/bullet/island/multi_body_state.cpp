#include "bullet/island/multi_body_state.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <vector>

#include "bullet/island/other_joints.h"

namespace sherd {

namespace {

/// The colliders of a multi-body that are in the world: of the base, then of the links.
std::vector<const btCollisionObject*> collidersOf(const btMultiBody& multi_body) {
    std::vector<const btCollisionObject*> colliders;
    const auto keep = [&](const btCollisionObject* collider) {
        if (collider && collider->getWorldArrayIndex() >= 0 && !collider->isStaticOrKinematicObject())
            colliders.push_back(collider);
    };
    keep(multi_body.getBaseCollider());
    for (int link = 0; link < multi_body.getNumLinks(); ++link) keep(multi_body.getLink(link).m_collider);
    return colliders;
}

const btCollisionObject* anyCollider(const btMultiBody* multi_body) {
    if (!multi_body) return nullptr;
    const auto colliders = collidersOf(*multi_body);
    return colliders.empty() ? nullptr : colliders.front();
}

/// One object of each multi-body, and each rigid body, that a constraint holds.
std::vector<const btCollisionObject*> endsOf(btMultiBodyConstraint& constraint) {
    std::vector<const btCollisionObject*> ends;
    for (const btMultiBody* multi_body : {constraint.getMultiBodyA(), constraint.getMultiBodyB()})
        if (const btCollisionObject* collider = anyCollider(multi_body)) ends.push_back(collider);
    for (const btRigidBody* body : rigidBodiesOf(constraint)) ends.push_back(body);
    return ends;
}

}  // namespace

void forEachMultiBodyJoint(
    btDiscreteDynamicsWorld& world,
    const std::function<void(const btCollisionObject&, const btCollisionObject&)>& visit) {
    auto* multi_world = dynamic_cast<btMultiBodyDynamicsWorld*>(&world);
    if (!multi_world) return;
    for (int i = 0; i < multi_world->getNumMultibodies(); ++i) {
        const auto colliders = collidersOf(*multi_world->getMultiBody(i));
        for (std::size_t c = 1; c < colliders.size(); ++c) visit(*colliders[0], *colliders[c]);
    }
    for (int i = 0; i < multi_world->getNumMultiBodyConstraints(); ++i) {
        const auto ends = endsOf(*multi_world->getMultiBodyConstraint(i));
        for (std::size_t e = 1; e < ends.size(); ++e) visit(*ends[0], *ends[e]);
    }
}

void addMultiBodies(btDiscreteDynamicsWorld& world,
                    const std::function<bool(const btCollisionObject&)>& inside, Island& island) {
    auto* multi_world = dynamic_cast<btMultiBodyDynamicsWorld*>(&world);
    if (!multi_world) return;
    const auto has = [&](const btMultiBody* multi_body) {
        const btCollisionObject* collider = anyCollider(multi_body);
        return collider && inside(*collider);
    };
    for (int i = 0; i < multi_world->getNumMultibodies(); ++i)
        if (has(multi_world->getMultiBody(i))) island.multi_bodies.push_back(multi_world->getMultiBody(i));
    for (int i = 0; i < multi_world->getNumMultiBodyConstraints(); ++i) {
        btMultiBodyConstraint* constraint = multi_world->getMultiBodyConstraint(i);
        const auto ends = endsOf(*constraint);
        if (std::any_of(ends.begin(), ends.end(), [&](const auto* end) { return inside(*end); }))
            island.multi_body_constraints.push_back(constraint);
    }
}

void dropPendingVelocity(btMultiBody& multi_body) {
    // The solver collects its changes beside the velocities; Bullet adds them once all islands are solved.
    multi_body.applyDeltaVeeMultiDof2(multi_body.getDeltaVelocityVector(), -1);
    multi_body.clearConstraintForces();
}

bool solveMultiBodyIsland(btDiscreteDynamicsWorld& world, btConstraintSolver& solver, Island& island,
                          const btContactSolverInfo& info, btIDebugDraw* drawer) {
    auto* multi_solver = dynamic_cast<btMultiBodyConstraintSolver*>(&solver);
    if (!multi_solver || !dynamic_cast<btMultiBodyDynamicsWorld*>(&world)) return false;
    multi_solver->solveMultiBodyGroup(
        island.bodies.data(), static_cast<int>(island.bodies.size()), island.manifolds.data(),
        static_cast<int>(island.manifolds.size()), island.constraints.data(),
        static_cast<int>(island.constraints.size()), island.multi_body_constraints.data(),
        static_cast<int>(island.multi_body_constraints.size()), info, drawer, world.getDispatcher());
    return true;
}

bool linkMotion(const btCollisionObject& object, const btVector3& world_point, btVector3& velocity,
                btScalar& inverse_mass) {
    const btMultiBodyLinkCollider* collider = btMultiBodyLinkCollider::upcast(&object);
    if (!collider) return false;
    const btMultiBody& multi_body = *collider->m_multiBody;
    const int link = collider->m_link;
    std::vector<btVector3> spins(multi_body.getNumLinks() + 1), speeds(multi_body.getNumLinks() + 1);
    multi_body.compTreeLinkVelocities(spins.data(), speeds.data());
    const btTransform& frame = collider->getWorldTransform();
    const btVector3 spin = multi_body.localDirToWorld(link, spins[link + 1]);
    velocity =
        multi_body.localDirToWorld(link, speeds[link + 1]) + spin.cross(world_point - frame.getOrigin());
    const btScalar mass = link < 0 ? multi_body.getBaseMass() : multi_body.getLinkMass(link);
    const bool fixed = link < 0 && multi_body.hasFixedBase();
    inverse_mass = fixed || mass <= 0 ? btScalar(0) : 1 / mass;
    return true;
}

}  // namespace sherd
