#pragma once

#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;
class btMultiBodyConstraint;
class btRigidBody;

namespace sherd {

/// What can hold a rigid body besides a btTypedConstraint: constraints of multi-bodies, and anchors and
/// joints of soft bodies. In worlds of other kinds there are none.

/// The rigid bodies that a constraint of a multi-body holds: none, one or two.
std::vector<btRigidBody*> rigidBodiesOf(const btMultiBodyConstraint& constraint);

/// Removes the constraints between multi-bodies and a rigid body from the world and returns them; they belong
/// to the app.
std::vector<btMultiBodyConstraint*> removeMultiBodyConstraints(btDiscreteDynamicsWorld& world,
                                                               const btRigidBody& body);

/// Frees the nodes that soft bodies have anchored to a body, fixes their joints with it where they are, and
/// drops their contacts with it.
void detachSoftBodies(btDiscreteDynamicsWorld& world, const btRigidBody& body);

}  // namespace sherd
