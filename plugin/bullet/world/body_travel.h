#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

namespace sherd {

/// Upper bound of the displacement of any point within `radius` of the origin, m.
btScalar travel(const btTransform& from, const btTransform& to, btScalar radius);

/// Of a ball about the origin of a body that its shape is in, m.
btScalar radiusAboutOrigin(const btCollisionObject& object);

}  // namespace sherd
