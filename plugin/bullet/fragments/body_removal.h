#pragma once

#include <vector>

class btDiscreteDynamicsWorld;
class btMultiBodyConstraint;
class btTypedConstraint;

namespace sherd {

struct Breakable;

/// Joints that were removed with a body. They belong to the app.
struct RemovedJoints {
    std::vector<btTypedConstraint*> constraints;
    std::vector<btMultiBodyConstraint*> multi_body_constraints;
};

/// Removes from the world what refers to a body: joints, and what soft bodies are attached to it with. If the
/// body is ours, it will not come back: its joints are disabled, and other bodies forget that they were not
/// to collide with it, since another one may be made at its address.
RemovedJoints detachFromWorld(btDiscreteDynamicsWorld& world, Breakable& breakable);

/// Removes a body from the world and detaches it, predictive contacts included. Activates the bodies that it
/// touched or was joined to.
RemovedJoints removeFromWorld(btDiscreteDynamicsWorld& world, Breakable& breakable);

}  // namespace sherd
