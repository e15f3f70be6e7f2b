#include "bullet/body_swap.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>
#include <unordered_set>

#include "bullet/fragment_motion.h"
#include "bullet/world_internals.h"

namespace sherd {

namespace {

void inheritSurface(const btRigidBody& parent, btRigidBody& piece) {
    piece.setFriction(parent.getFriction());
    piece.setRollingFriction(parent.getRollingFriction());
    piece.setSpinningFriction(parent.getSpinningFriction());
    piece.setRestitution(parent.getRestitution());
    const int surface_flags = btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING;
    if (parent.getCollisionFlags() & surface_flags)
        piece.setContactStiffnessAndDamping(parent.getContactStiffness(), parent.getContactDamping());
    piece.setContactProcessingThreshold(parent.getContactProcessingThreshold());
    piece.setCollisionFlags(parent.getCollisionFlags());
}

void inheritMotionRules(const btRigidBody& parent, btRigidBody& piece) {
    piece.setDamping(parent.getLinearDamping(), parent.getAngularDamping());
    piece.setSleepingThresholds(parent.getLinearSleepingThreshold(), parent.getAngularSleepingThreshold());
    piece.setFlags(parent.getFlags());
    piece.setLinearFactor(parent.getLinearFactor());
    piece.setAngularFactor(parent.getAngularFactor());
    piece.setGravity(parent.getGravity());
    piece.setCcdMotionThreshold(parent.getCcdMotionThreshold());
    btVector3 centre;
    btScalar radius;
    piece.getCollisionShape()->getBoundingSphere(centre, radius);
    piece.setCcdSweptSphereRadius(std::min(parent.getCcdSweptSphereRadius(), radius));
    if (parent.getActivationState() == DISABLE_DEACTIVATION) piece.setActivationState(DISABLE_DEACTIVATION);
}

void inheritAppData(btRigidBody& parent, btRigidBody& piece) {
    piece.setUserPointer(parent.getUserPointer());
    piece.setUserIndex(parent.getUserIndex());
    piece.setUserIndex2(parent.getUserIndex2());
    piece.setUserIndex3(parent.getUserIndex3());
    for (int i = 0; i < parent.getNumObjectsWithoutCollision(); ++i)
        piece.setIgnoreCollisionCheck(parent.getObjectWithoutCollision(i), true);
    btVector3 colour;
    if (parent.getCustomDebugColor(colour)) piece.setCustomDebugColor(colour);
}

/// The manifolds of Bullet's contact prediction belong to no collision pair, so removing the body leaves
/// them.
void releasePredictiveContacts(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    auto& manifolds = WorldInternals::predictiveManifolds(world);
    for (int i = manifolds.size() - 1; i >= 0; --i) {
        btPersistentManifold* manifold = manifolds[i];
        if (manifold->getBody0() != &body && manifold->getBody1() != &body) continue;
        manifolds.removeAtIndex(i);
        world.getDispatcher()->releaseManifold(manifold);
    }
}

void activateNeighbours(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
        if (a == &body) b->activate();
        if (b == &body) a->activate();
    }
}

std::vector<btTypedConstraint*> removeJoints(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    std::vector<btTypedConstraint*> removed;
    for (int i = world.getNumConstraints() - 1; i >= 0; --i) {
        btTypedConstraint* constraint = world.getConstraint(i);
        if (&constraint->getRigidBodyA() != &body && &constraint->getRigidBodyB() != &body) continue;
        constraint->getRigidBodyA().activate();
        constraint->getRigidBodyB().activate();
        world.removeConstraint(constraint);
        removed.push_back(constraint);
    }
    std::reverse(removed.begin(), removed.end());
    return removed;
}

}  // namespace

std::vector<std::unique_ptr<Breakable>> makeFragmentBodies(const Breakable& parent,
                                                           const std::vector<Fragment>& fragments) {
    btRigidBody& whole = *parent.body;
    const double mass_scale = 1 / (whole.getInvMass() * parent.asset.mass());
    const btTransform world_from_asset = parent.placed(whole.getWorldTransform());
    std::vector<std::unique_ptr<Breakable>> pieces;
    std::vector<btRigidBody*> bodies;
    for (const Fragment& fragment : fragments) {
        auto piece = std::make_unique<Breakable>(BreakableAsset(fragment.solid));
        piece->owned = makeRigidBody(*fragment.solid, fragment.boxes, mass_scale);
        piece->body = piece->owned.body.get();
        piece->body_from_asset = principalFrame(fragment.solid->moments()).body_from_asset;
        piece->body->setCenterOfMassTransform(world_from_asset * piece->body_from_asset.inverse());
        inheritSurface(whole, *piece->body);
        inheritMotionRules(whole, *piece->body);
        inheritAppData(whole, *piece->body);
        bodies.push_back(piece->body);
        pieces.push_back(std::move(piece));
    }
    shareMotion(whole, bodies);
    shareForces(whole, bodies);
    return pieces;
}

double momentumError(const btRigidBody& parent, const std::vector<std::unique_ptr<Breakable>>& fragments) {
    std::vector<const btRigidBody*> bodies;
    for (const auto& fragment : fragments) bodies.push_back(fragment->body);
    return momentumDifference(parent, bodies);
}

double dropDebris(const std::vector<Fragment>& fragments, std::vector<std::unique_ptr<Breakable>>& pieces) {
    double mass = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!fragments[i].dropped) continue;
        mass += 1 / static_cast<double>(pieces[i]->body->getInvMass());
        pieces[i].reset();
    }
    pieces.erase(std::remove(pieces.begin(), pieces.end(), nullptr), pieces.end());
    return mass;
}

std::vector<btTypedConstraint*> removeFromWorld(btDiscreteDynamicsWorld& world, btRigidBody& body) {
    activateNeighbours(world, body);
    std::vector<btTypedConstraint*> joints = removeJoints(world, body);
    releasePredictiveContacts(world, body);
    world.removeRigidBody(&body);
    return joints;
}

void addToWorld(btDiscreteDynamicsWorld& world, const std::vector<std::unique_ptr<Breakable>>& fragments,
                int group, int mask, btScalar time_step_s) {
    for (const auto& fragment : fragments) {
        btRigidBody& body = *fragment->body;
        const btVector3 own_gravity = body.getGravity();
        world.addRigidBody(&body, group, mask);
        body.setGravity(own_gravity);  // adding a body sets it to the world's
        // Adding a body sets its bounds without the margin for contacts and without its motion in this step.
        body.predictIntegratedTransform(time_step_s, body.getInterpolationWorldTransform());
        world.updateSingleAabb(&body);
    }
}

void findContactsOf(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& new_bodies) {
    const auto* tree = dynamic_cast<const btDbvtBroadphase*>(world.getBroadphase());
    if (!tree || tree->m_deferedcollide)
        world.getBroadphase()->calculateOverlappingPairs(world.getDispatcher());
    auto* dispatcher = dynamic_cast<btCollisionDispatcher*>(world.getDispatcher());
    if (!dispatcher) {
        world.getDispatcher()->dispatchAllCollisionPairs(world.getPairCache(), world.getDispatchInfo(),
                                                         world.getDispatcher());
        return;
    }
    const std::unordered_set<const void*> is_new(new_bodies.begin(), new_bodies.end());
    btBroadphasePairArray& pairs = world.getPairCache()->getOverlappingPairArray();
    for (int i = 0; i < pairs.size(); ++i) {
        const bool concerned = is_new.count(pairs[i].m_pProxy0->m_clientObject) ||
                               is_new.count(pairs[i].m_pProxy1->m_clientObject);
        if (concerned) dispatcher->getNearCallback()(pairs[i], *dispatcher, world.getDispatchInfo());
    }
}

}  // namespace sherd
