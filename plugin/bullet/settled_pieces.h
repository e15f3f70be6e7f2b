#pragma once

#include "bullet/breakable.h"

namespace sherd {

/// Lets fragments fall asleep that stay where they are. A small piece that is caught among heavier ones never
/// comes to rest by its velocity, which is what Bullet asks for: the solver does not converge there, pushes
/// it one way in a step and back in the next, and keeps the whole pile awake. A fragment that no point of has
/// left its surroundings for Bullet's time of deactivation counts as one at rest, as long as it stays there.
/// For before a solve, of bodies that are in the world.
void settlePieces(const BreakableRegistry& breakables, double time_step_s);

/// For after a solve: what fell asleep in it has all the time to begin to move once it is woken up.
void forgetSettled(const BreakableRegistry& breakables);

}  // namespace sherd
