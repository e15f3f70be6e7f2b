#pragma once

#include <memory>

class btRigidBody;

namespace sherd {

/// Keeps what joints of the app's need of a body that is gone. A btTypedConstraint holds references to its
/// two bodies that cannot be changed, and `removeConstraint` follows them whenever the app calls it. Nobody
/// tells when the last joint is gone, so the body stays until the process ends: without shape, mass and
/// motion, about a kilobyte. A joint that the app puts back into a world is one to a fixed place.
void keepForJoints(std::unique_ptr<btRigidBody> body);

}  // namespace sherd
