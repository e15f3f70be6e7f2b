#pragma once

#include <sherd/events.h>

#include <memory>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/bodies/decided_blow.h"
#include "bullet/island/island_state.h"
#include "fracture/pipeline.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// A body that factors let turn about one axis alone gets its moment of inertia about that for all axes.
/// Bullet's solver would take a turn about the others, which it then leaves out, to turn it about this one,
/// too, and it would gain energy without end.
void turnAboutOneAxis(btRigidBody& body);

/// The fragments that `parent` broke into as rigid bodies, not in a world yet. They are placed where the
/// parent's material is, move with the rigid motion that has the parent's linear and angular momentum, and
/// inherit everything that an app may have set on the parent: friction, restitution, damping, factors, flags,
/// user pointer, sleeping thresholds, their share of the forces. Fragments that a support holds are static,
/// and the others of such a body move as it did. The parent must have its state from before the solve.
/// `world_gravity`, m/s^2, is for what comes off a static body. `inside_step`: the forces of this step were
/// given to the parent already.
std::vector<std::unique_ptr<Breakable>> makeFragmentBodies(const Breakable& parent,
                                                           const DecidedBlow& decided,
                                                           const btVector3& world_gravity, bool inside_step);

/// Difference between the momentum of a body and of its fragments, linear and angular (about the body's
/// centre), relative to the sum of the fragments' own; the larger of the two. 0 where the world holds
/// fragments: it takes their momentum.
double momentumError(const btRigidBody& parent, const std::vector<std::unique_ptr<Breakable>>& fragments);

/// Deletes the pieces whose fragments are dropped as debris; returns their mass, kg.
double dropDebris(const std::vector<Fragment>& fragments, std::vector<std::unique_ptr<Breakable>>& pieces);

/// Adds fragments, each with its own filter; `time_step_s` is that of the current step, 0 between steps.
void addToWorld(btDiscreteDynamicsWorld& world, const std::vector<Breakable*>& fragments,
                btScalar time_step_s);

/// Finds the contacts of bodies that were added to the world after this step's collision detection.
void findContactsOf(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& new_bodies);

}  // namespace sherd
