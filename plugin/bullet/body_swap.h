#pragma once

#include <sherd/events.h>

#include <memory>
#include <vector>

#include "bullet/breakable.h"
#include "bullet/island_state.h"
#include "fracture/pipeline.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// The fragments of `parent` as rigid bodies, in no world yet: placed where the parent's material is, moving
/// with the rigid motion that carries the parent's linear and angular momentum, and with everything an app
/// may have set on the parent: friction, restitution, damping, factors, flags, user pointer, sleeping
/// thresholds, its share of the forces. The parent must stand and move as before the solve.
std::vector<std::unique_ptr<Breakable>> makeFragmentBodies(const Breakable& parent,
                                                           const std::vector<Fragment>& fragments);

/// Difference between the momentum of a body and of its fragments, linear and angular (about the body's
/// centre), relative to the sum of the fragments' own; the larger of the two.
double momentumError(const btRigidBody& parent, const std::vector<std::unique_ptr<Breakable>>& fragments);

/// Deletes the pieces whose fragments are to be dropped; returns their mass, kg.
double dropDebris(const std::vector<Fragment>& fragments, std::vector<std::unique_ptr<Breakable>>& pieces);

/// Takes a body out of the world with all that would go on pointing to it: joints, predictive contacts. Wakes
/// whatever touched it or was joined to it. Returns the joints, which belong to the app.
std::vector<btTypedConstraint*> takeOutOfWorld(btDiscreteDynamicsWorld& world, btRigidBody& body);

/// Adds fragments with a collision group and mask; `time_step_s` is that of the step under way.
void addToWorld(btDiscreteDynamicsWorld& world, const std::vector<std::unique_ptr<Breakable>>& fragments,
                int group, int mask, btScalar time_step_s);

/// Finds the contacts of bodies that came into the world after this step's collision detection.
void findContactsOf(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& newcomers);

}  // namespace sherd
