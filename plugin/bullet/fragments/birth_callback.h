#pragma once

#include <sherd/fragment_birth.h>

#include <memory>
#include <vector>

#include "bullet/bodies/breakable.h"

class btDiscreteDynamicsWorld;

namespace sherd {

/// Shows a fragment to the app before it enters the world, and takes over the filters that the app sets. Its
/// place is put back should the app, or Bullet's setMotionState, have changed it. What the callback throws
/// becomes a sentence of the event, also if it is of a step that the callback begins.
void announceBirth(btDiscreteDynamicsWorld& world, const FragmentCallback& callback, const Breakable& parent,
                   Breakable& fragment, BlowEvent& event);

}  // namespace sherd
