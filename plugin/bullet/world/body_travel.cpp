#include "bullet/world/body_travel.h"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <cmath>

namespace sherd {

btScalar travel(const btTransform& from, const btTransform& to, btScalar radius) {
    btScalar squared_turn = 0;
    for (int row = 0; row < 3; ++row) squared_turn += (to.getBasis()[row] - from.getBasis()[row]).length2();
    return (to.getOrigin() - from.getOrigin()).length() + std::sqrt(squared_turn) * radius;
}

btScalar radiusAboutOrigin(const btCollisionObject& object) {
    btVector3 centre;
    btScalar radius;
    object.getCollisionShape()->getBoundingSphere(centre, radius);
    return centre.length() + radius;
}

}  // namespace sherd
