#pragma once

#include "bullet/bodies/breakable.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// Lets fragments fall asleep that stay where they are. A small piece that is caught among heavier ones never
/// comes to rest by its velocity, which is what Bullet asks for: the solver does not converge there, pushes
/// it one way in a step and back in the next, and keeps the whole pile awake. A fragment that no point of has
/// left its surroundings for Bullet's time of deactivation counts as one at rest, as long as it stays there.
/// And one that rocks on a spot for longer than any piece does that falls or rolls spins less and less: in
/// steps of 1/60 s a contact that the solver lacks lets a splinter tip by a tenth of a turn, on and on.
/// So does one that turns on a spot for as long as it takes Bullet to let bodies sleep, and after twice that
/// time it counts as one at rest: on rough ground a shard may turn for good, and keeps its heap awake.
/// Pieces on joints and without gravity are left alone but for the first.
/// Pieces in the ground are moved out of it, little by little.
/// Where the app lets bodies sleep earlier than Bullet's 2 s, pieces deep in the ground stay awake for that
/// long: Bullet lifts them out of it more slowly than what counts as rest. For before a solve, of bodies that
/// are in the world.
void settlePieces(const btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                  double time_step_s);

/// For after a solve: what fell asleep in it has all the time to begin to move once it is woken up.
void forgetSettled(const BreakableRegistry& breakables);

}  // namespace sherd
