#include "bullet/shapes/inner_ball.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

namespace sherd {

namespace {

/// Of the smallest extent. Bodies at rest on a face are further than that from their centre: a pyramid's is
/// at a quarter of its height.
constexpr btScalar radius_share = btScalar(0.2);

struct Bounds {
    btVector3 low, high;
    bool contain(const btVector3& p) const {
        return low.x() <= p.x() && low.y() <= p.y() && low.z() <= p.z() && p.x() <= high.x() &&
               p.y() <= high.y() && p.z() <= high.z();
    }
    InnerBall ball(const btVector3& centre) const {
        const btVector3 size = high - low;
        return {centre, radius_share * size[size.minAxis()]};
    }
};

Bounds boundsOf(const btCollisionShape& shape, const btTransform& frame) {
    Bounds bounds;
    shape.getAabb(frame, bounds.low, bounds.high);
    return bounds;
}

}  // namespace

InnerBall innerBall(const btCollisionShape& shape) {
    const btVector3 centre_of_mass(0, 0, 0);
    const InnerBall about_centre = boundsOf(shape, btTransform::getIdentity()).ball(centre_of_mass);
    if (!shape.isCompound()) return about_centre;
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    InnerBall nearest = about_centre;
    btScalar least = BT_LARGE_FLOAT;
    for (int i = 0; i < compound.getNumChildShapes(); ++i) {
        const btCollisionShape& child = *compound.getChildShape(i);
        const btTransform& frame = compound.getChildTransform(i);
        if (boundsOf(child, btTransform::getIdentity()).contain(frame.invXform(centre_of_mass)))
            return about_centre;
        const Bounds bounds = boundsOf(child, frame);
        const btVector3 middle = (bounds.low + bounds.high) / 2;
        if (!(middle.length2() < least)) continue;
        least = middle.length2();
        nearest = boundsOf(child, btTransform::getIdentity()).ball(middle);
    }
    return nearest;
}

}  // namespace sherd
