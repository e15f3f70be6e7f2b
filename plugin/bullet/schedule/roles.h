#pragma once

#include <LinearMath/btVector3.h>

#include <optional>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/island/island_state.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// An object of a world that takes part in a rehearsal.
struct Role {
    const btCollisionObject* object = nullptr;
    Breakable* breakable = nullptr;  ///< of the object, if it is breakable
    /// How its velocity changes, m/s^2, where something else than gravity does that: an app's force, damping.
    std::optional<btVector3> driven;
};

/// Whether a blow on a body could be foreseen, and is worth that: a whole body, or a fragment that is
/// prepared or expects a factor, not too new to break, and on no joint.
bool isForeseeable(const Breakable& breakable, double time_s);

/// The bodies whose ways are worth looking at: awake, on no joint, and faster than what rests or creeps.
std::vector<btRigidBody*> fastBodies(const btDiscreteDynamicsWorld& world);

/// Whether a body may bring some energy to what it meets, by its speed.
bool mayBring(const btRigidBody& mover, double energy_j);

/// What a mover may break on its way of the next `ahead_s` seconds, by its energy, and itself if it meets
/// anything; in the order in which the broadphase has them.
std::vector<const Breakable*> breakablesAround(btDiscreteDynamicsWorld& world,
                                               const BreakableRegistry& breakables, const btRigidBody& mover,
                                               double ahead_s, double time_s);

/// What touches what in a world.
class Touching {
  public:
    explicit Touching(const btDiscreteDynamicsWorld& world);
    /// What touches an object of the world, in the order of the dispatcher's manifolds; several times if they
    /// have several.
    const std::vector<const btCollisionObject*>& of(const btCollisionObject& object) const;

  private:
    std::vector<std::vector<const btCollisionObject*>> of_;  // by the objects' places in the world
};

/// What a rehearsal of a mover's next `ahead_s` seconds needs, in the order of the world's objects: itself,
/// the nearest of what it may meet on its way, what touches one of these, and what all that stands on, as far
/// as there is room. Empty if it meets nothing that it may break, nor anything that may break it, and if
/// something turns it aside already. `before`: the state before the last step.
std::vector<Role> rolesAround(btDiscreteDynamicsWorld& world, const Touching& touching,
                              const BreakableRegistry& breakables, const StepSnapshot& before,
                              const btRigidBody& mover, double ahead_s, double time_s);

}  // namespace sherd
