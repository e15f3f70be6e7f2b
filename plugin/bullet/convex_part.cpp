#include "bullet/convex_part.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

namespace sherd {

ConvexPart partOf(const btCollisionObject& object, btTransform transform, int child) {
    const btCollisionShape* shape = object.getCollisionShape();
    if (shape->isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(*shape);
        if (child < 0 || child >= compound.getNumChildShapes()) return {};
        shape = compound.getChildShape(child);
        transform = transform * compound.getChildTransform(child);
    }
    if (!shape->isPolyhedral()) return {};
    return {static_cast<const btPolyhedralConvexShape*>(shape), transform};
}

btScalar marginAround(const btPolyhedralConvexShape& shape) {
    return shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? 0 : shape.getMargin();
}

}  // namespace sherd
