#pragma once

#include <LinearMath/btTransform.h>

#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;

namespace sherd {

/// Ground surfaces that are kinematic, and how each has moved since the end of the last step: Bullet sets it
/// where it is to be at the end of a step before anything else of that step, with whatever stands on it left
/// where it was.
class MovedGround {
  public:
    struct Surface {
        const btCollisionObject* ground = nullptr;
        btTransform moved = btTransform::getIdentity();  ///< takes what went with it from there to here
    };

    /// Those that moved, in the order of the world's array. One that is new has not moved.
    std::vector<Surface> since(const btDiscreteDynamicsWorld& world) const;
    /// For the end of a step: notes where they stand.
    void note(const btDiscreteDynamicsWorld& world);

  private:
    struct Stood {
        const btCollisionObject* ground;  // may be dead: compared only
        btTransform where;
    };
    std::vector<Stood> stood_;
};

}  // namespace sherd
