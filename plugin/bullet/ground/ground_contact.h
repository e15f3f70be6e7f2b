#pragma once

#include <memory>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/ground/moved_ground.h"
#include "bullet/island/island_state.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// Keeps breakable bodies on their side of ground that is a surface without an inside (triangle meshes and
/// height fields, static or kinematic). Bullet pushes a body out of a triangle on the side where less of the
/// body is, so that a small or thin one falls through as soon as it is more than half beyond. And fragments
/// are born in the ground: a body that breaks there has moved into it in the steps before. A ball inside a
/// body tells its side:
/// - what breaks is set back until the centre of no fragment's ball is beyond the ground, as seen from where
///   the body was clear of it a moment ago, or else a step ago, or from its own ball; its fragments lose what
///   gravity has made it faster by on the way that they are set back;
/// - contacts that push a body to the other side are left out; the ball of a fragment touches the ground as
///   well, with a contact that knows the side, and what no other contact holds stands on the vertices that
///   are in the ground;
/// - the centre of the ball does not cross the ground in a step.

/// The centre of a body's ball, before a solve, or where it would be if it had gone with the ground that has
/// moved across it since the last step: on the body's side of all ground.
btVector3 ballOnItsSide(btDiscreteDynamicsWorld& world, const Breakable& breakable,
                        const MovedSurfaces& moved);

/// Moves the fragments of `whole` as one. It is in the world, and they are not yet.
void setBackOnGround(btDiscreteDynamicsWorld& world, const Breakable& whole,
                     const std::vector<std::unique_ptr<Breakable>>& fragments, const MovedSurfaces& moved);

/// Adds the contacts of the balls, which last until the end of the solve, and leaves out wrong ones. To be
/// called before a solve.
void addGroundContacts(btDiscreteDynamicsWorld& world, const std::vector<const Breakable*>& bodies,
                       const MovedSurfaces& moved);

/// After positions are integrated, keeps bodies from crossing the ground, and notes the ways of all bodies
/// since the state before the solve (which moves bodies, too). Where there is no ground these are forgotten.
/// Ends the step for `moved_ground`.
void stopAtGround(btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                  const StepSnapshot& before, MovedGround& moved_ground);

}  // namespace sherd
