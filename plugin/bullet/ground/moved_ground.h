#pragma once

#include <LinearMath/btTransform.h>

#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;

namespace sherd {

/// A ground surface that the app has moved since the last step. Bullet sets it where it is to be before
/// anything else of a step, with whatever stands on it left where it was.
struct MovedSurface {
    const btCollisionObject* ground = nullptr;
    btTransform moved = btTransform::getIdentity();  ///< takes what went with it from there to here

    /// Where a point would be that had gone with it; where it is, if that is so far away that the surface was
    /// set there rather than moved.
    btVector3 carry(const btVector3& point) const;
};
using MovedSurfaces = std::vector<MovedSurface>;

/// Ground surfaces that are kinematic, and how each has moved since the end of the last step.
class MovedGround {
  public:
    /// In the order of the world's array. A surface that is new has not moved.
    MovedSurfaces since(const btDiscreteDynamicsWorld& world) const;
    /// For just before the solve of a step, in which they stay where they are: finds them for `surfaces`.
    void beginStep(const btDiscreteDynamicsWorld& world) { surfaces_ = since(world); }
    const MovedSurfaces& surfaces() const { return surfaces_; }
    /// Notes where they stand.
    void endStep(const btDiscreteDynamicsWorld& world);

  private:
    struct Stood {
        const btCollisionObject* ground;  // may be dead: compared only
        btTransform where;
    };
    std::vector<Stood> stood_;
    MovedSurfaces surfaces_;
};

}  // namespace sherd
