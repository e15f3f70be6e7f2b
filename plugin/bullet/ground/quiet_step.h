#pragma once

class btDiscreteDynamicsWorld;

namespace sherd {

class BreakableRegistry;

/// Whether an object of the world is awake that can move.
bool anythingAwake(const btDiscreteDynamicsWorld& world);

/// Whether nothing can break in the step that is about to be solved: all bodies of the world together carry
/// less energy than it takes to break any that is breakable. What the app pushes them with in the step
/// counts. False where that cannot be told: beside multi-bodies, soft bodies and kinematic bodies that move.
bool nothingCanBreak(const btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                     double time_step_s);

}  // namespace sherd
