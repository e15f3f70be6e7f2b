#pragma once

#include <memory>
#include <vector>

#include "bullet/breakable.h"
#include "bullet/island_state.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// Keeps fragments on their side of ground that is a surface without an inside (static triangle meshes and
/// height fields). Bullet pushes a body out of a triangle on the side where less of the body is, so that a
/// small or thin fragment falls through as soon as it is more than half beyond. And fragments are born in the
/// ground: a body that breaks there has moved into it in the step before. A ball inside the fragment tells
/// its side:
/// - what breaks is set back until the centre of no ball is beyond the ground, as seen from where it was a
///   step ago and from its own ball;
/// - the ball touches the ground as well, with a contact that knows the side, and contacts that push the
///   fragment to the other side are left out;
/// - the centre of the ball does not cross the ground in a step.

/// Moves the fragments of `whole` as one. It is in the world, and they are not yet.
void setBackOnGround(btDiscreteDynamicsWorld& world, const Breakable& whole,
                     const std::vector<std::unique_ptr<Breakable>>& fragments);

/// Adds the contacts of the balls, which last until the next step, as predictive contacts do. To be called
/// before a solve.
void addGroundContacts(btDiscreteDynamicsWorld& world, const std::vector<const Breakable*>& fragments);

/// After positions are integrated, keeps fragments from crossing the ground, and notes the ways of all bodies
/// since the state before the solve (which moves bodies, too).
void stopAtGround(btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                  const StepSnapshot& before);

}  // namespace sherd
