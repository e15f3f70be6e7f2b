#include "bullet/shapes/convex_part.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

namespace sherd {

PlacedShape childOf(const btCollisionObject& object, btTransform transform, int child) {
    const btCollisionShape* shape = object.getCollisionShape();
    if (shape->isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(*shape);
        if (child < 0 || child >= compound.getNumChildShapes()) return {};
        shape = compound.getChildShape(child);
        transform = transform * compound.getChildTransform(child);
    }
    return {shape, transform};
}

ConvexPart partOf(const btCollisionObject& object, btTransform transform, int child) {
    const PlacedShape placed = childOf(object, transform, child);
    if (!placed.shape || !placed.shape->isPolyhedral()) return {};
    return {static_cast<const btPolyhedralConvexShape*>(placed.shape), placed.transform};
}

btScalar marginAround(const btPolyhedralConvexShape& shape) {
    return shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? 0 : shape.getMargin();
}

}  // namespace sherd
