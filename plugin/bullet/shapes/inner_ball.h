#pragma once

#include <LinearMath/btVector3.h>

class btCollisionShape;

namespace sherd {

/// A small ball well inside a collision shape, in the shape's frame, m: about the centre of mass, or about
/// the middle of the nearest child where the centre of mass is in a hollow of a compound.
struct InnerBall {
    btVector3 centre = btVector3(0, 0, 0);
    btScalar radius = 0;
};

/// `shape` has its centre of mass at its origin, as Bullet wants it.
InnerBall innerBall(const btCollisionShape& shape);

}  // namespace sherd
