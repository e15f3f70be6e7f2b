#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "bullet/island/island_state.h"
#include "bullet/island/multi_body_state.h"
#include "core/numerics/union_find.h"

namespace sherd {

namespace {

/// Static and kinematic objects do not connect islands.
bool connects(const btCollisionObject& object) {
    return object.getWorldArrayIndex() >= 0 && !object.isStaticOrKinematicObject();
}

bool joins(const btPersistentManifold& manifold, btDispatcher& dispatcher) {
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    const bool in_world = a->getWorldArrayIndex() >= 0 && b->getWorldArrayIndex() >= 0;
    return in_world && manifold.getNumContacts() > 0 && dispatcher.needsResponse(a, b);
}

bool isSeed(const std::vector<char>& is_seed, const btCollisionObject& object) {
    return object.getWorldArrayIndex() >= 0 && is_seed[object.getWorldArrayIndex()];
}

/// Calls visit(object, object) for every contact and every joint between two objects.
template <class Visit>
void forEachJoint(btDiscreteDynamicsWorld& world, const Visit& visit) {
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (joins(manifold, dispatcher)) visit(*manifold.getBody0(), *manifold.getBody1());
    }
    for (int i = 0; i < world.getNumConstraints(); ++i) {
        const btTypedConstraint& constraint = *world.getConstraint(i);
        visit(constraint.getRigidBodyA(), constraint.getRigidBodyB());
    }
    forEachMultiBodyJoint(world, visit);
}

}  // namespace

Island connectedIsland(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& seeds) {
    const auto& objects = world.getCollisionObjectArray();
    UnionFind groups(static_cast<std::size_t>(objects.size()));  // of places in the world's array of objects
    forEachJoint(world, [&](const btCollisionObject& a, const btCollisionObject& b) {
        if (connects(a) && connects(b)) groups.unite(a.getWorldArrayIndex(), b.getWorldArrayIndex());
    });
    std::vector<char> wanted(objects.size(), 0), is_seed(objects.size(), 0);
    const auto want = [&](const btCollisionObject& object) {
        wanted[groups.root(object.getWorldArrayIndex())] = 1;
    };
    for (const btCollisionObject* seed : seeds) {
        if (seed->getWorldArrayIndex() < 0) continue;  // the app took it out while the step was solved
        is_seed[seed->getWorldArrayIndex()] = 1;
        want(*seed);
    }
    forEachJoint(world, [&](const btCollisionObject& a, const btCollisionObject& b) {  // of static seeds
        if (connects(a) && isSeed(is_seed, b)) want(a);
        if (connects(b) && isSeed(is_seed, a)) want(b);
    });
    const auto inside = [&](const btCollisionObject& object) {
        return connects(object) && wanted[groups.root(object.getWorldArrayIndex())];
    };

    Island island;
    for (int i = 0; i < objects.size(); ++i)
        if (inside(*objects[i]) && objects[i]->getInternalType() != btCollisionObject::CO_SOFT_BODY)
            island.bodies.push_back(objects[i]);
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
        if (joins(*manifold, dispatcher) && (inside(*manifold->getBody0()) || inside(*manifold->getBody1())))
            island.manifolds.push_back(manifold);
    }
    for (int i = 0; i < world.getNumConstraints(); ++i) {
        btTypedConstraint* constraint = world.getConstraint(i);
        if (inside(constraint->getRigidBodyA()) || inside(constraint->getRigidBodyB()))
            island.constraints.push_back(constraint);
    }
    addMultiBodies(world, inside, island);
    return island;
}

void solveIsland(btDiscreteDynamicsWorld& world, btConstraintSolver& solver, Island& island,
                 const btContactSolverInfo& info, btIDebugDraw* drawer) {
    if (island.bodies.empty() || solveMultiBodyIsland(world, solver, island, info, drawer)) return;
    solver.solveGroup(island.bodies.data(), static_cast<int>(island.bodies.size()), island.manifolds.data(),
                      static_cast<int>(island.manifolds.size()), island.constraints.data(),
                      static_cast<int>(island.constraints.size()), info, drawer, world.getDispatcher());
}

}  // namespace sherd
