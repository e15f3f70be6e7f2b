#pragma once

#include <LinearMath/btVector3.h>

#include <functional>

#include "bullet/island/island_state.h"

namespace sherd {

/// What Featherstone multi-bodies need where an island is solved again. A link is a collision object of its
/// own, but its motion is that of its multi-body. In worlds of other kinds these functions do nothing.

/// Calls visit(object, object) for links of one multi-body and for multi-bodies that a constraint joins.
void forEachMultiBodyJoint(
    btDiscreteDynamicsWorld& world,
    const std::function<void(const btCollisionObject&, const btCollisionObject&)>& visit);

/// Adds the multi-bodies whose links are inside, and their constraints, to an island.
void addMultiBodies(btDiscreteDynamicsWorld& world,
                    const std::function<bool(const btCollisionObject&)>& inside, Island& island);

/// Discards the change of velocity that the solve computed and Bullet has not applied yet.
void dropPendingVelocity(btMultiBody& multi_body);

/// Solves an island of a multi-body world; false in worlds of other kinds.
bool solveMultiBodyIsland(btDiscreteDynamicsWorld& world, btConstraintSolver& solver, Island& island,
                          const btContactSolverInfo& info, btIDebugDraw* drawer);

/// A link's velocity at a point and its inverse mass (of the link alone); false if the object is not a link.
bool linkMotion(const btCollisionObject& object, const btVector3& world_point, btVector3& velocity,
                btScalar& inverse_mass);

}  // namespace sherd
