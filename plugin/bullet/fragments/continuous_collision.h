#pragma once

#include <LinearMath/btTransform.h>

#include <functional>
#include <utility>
#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;
class btRigidBody;

namespace sherd {

/// Continuous collision (setCcdMotionThreshold) among fragments. Bullet sweeps a fast body against all others
/// as they stand when a step begins: once before the solve, for a "predictive" contact with the nearest, and
/// once after it, to stop the body there. What goes through a body that it breaks would be stopped anew by
/// each fragment, since they all stand where the whole body stood, and would not notice what comes behind
/// them. So fragments take no part in either sweep; instead the moving body has predictive contacts with all
/// of them that are in its way, and the solve lets it push them ahead.

/// Objects that are in no sweep of Bullet's.
using IsFragment = std::function<bool(const btCollisionObject&)>;

/// The bodies that were swept in the current step and have a predictive contact with an object of that kind.
std::vector<btRigidBody*> sweptInto(btDiscreteDynamicsWorld& world,
                                    const std::function<bool(const btCollisionObject&)>& is_hit);

/// What a body of the current step is going to hit, besides fragments, in its own sweep: Bullet's predictive
/// contact with the nearest object that is neither a fragment nor `passes`.
struct Obstacles {
    IsFragment is_fragment;
    std::function<bool(const btCollisionObject&)> passes;
};

/// Makes the predictive contacts of a swept body anew. Returns the object besides fragments that it is about
/// to hit, nullptr if there is none.
const btCollisionObject* predictContacts(btDiscreteDynamicsWorld& world, btRigidBody& body,
                                         const Obstacles& obstacles, btScalar time_step_s);

/// Keeps fragments out of the sweep that follows a solve.
class SweepExceptions {
  public:
    ~SweepExceptions() { end(); }
    void begin(btDiscreteDynamicsWorld& world, const IsFragment& is_fragment, btScalar time_step_s);
    /// Leaves every body as it was.
    void end();

  private:
    std::vector<std::pair<btCollisionObject*, const btCollisionObject*>> pairs_;  // fragment, swept body
};

}  // namespace sherd
