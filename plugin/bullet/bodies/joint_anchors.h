#pragma once

#include <memory>

#include "bullet/bodies/body_token.h"

class btRigidBody;
class btTypedConstraint;

namespace sherd {

/// A btTypedConstraint holds references to its two bodies that cannot be changed, and `removeConstraint`
/// follows them whenever the app calls it. So the bodies of a joint that was taken out of a world have to
/// outlive it, both of them: the one with which it went, and the other, whenever that goes.
void noteRemovedJoint(const btTypedConstraint& joint);

/// Keeps of a body what removed joints need, or deletes it if there are none. Nobody tells when the last
/// joint is gone, so the body stays until the process ends: without shape, mass and motion, about a kilobyte.
/// A joint that the app puts back into a world is one to a fixed place.
void keepForJoints(std::unique_ptr<btRigidBody> body, BodyToken token);

}  // namespace sherd
