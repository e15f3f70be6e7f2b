#pragma once

#include <LinearMath/btVector3.h>

#include <vector>

class btCollisionObject;
class btDispatcher;

namespace sherd {

/// What struck a body, and how.
struct StrikeOnWhole {
    const btCollisionObject* striker = nullptr;
    btVector3 push = btVector3(0, 0, 0);  ///< unit, on the body, world frame
    btScalar way_m = 0;                   ///< of the striker since it met the body, in this step
};

/// A step takes a striker deep into a body before Bullet knows of it. Among the pieces it is nearest to being
/// out sideways, along a crack, and contacts that push them apart stop nothing: it would fly on, and leave
/// them where they are. So contacts of new pieces that are deep for its way in the step push as it struck the
/// whole. To be called for contacts that were just found.
void pushAsTheWholeWasStruck(btDispatcher& dispatcher, const StrikeOnWhole& strike,
                             const std::vector<btCollisionObject*>& pieces);

}  // namespace sherd
