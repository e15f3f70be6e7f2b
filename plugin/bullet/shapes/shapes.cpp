#include "bullet/shapes/shapes.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>

#include <algorithm>

#include "bullet/world/conversions.h"

namespace sherd {

namespace {

std::vector<Vec3> boxCorners(const btBoxShape& box) {
    const Vec3 half = fromBullet(box.getHalfExtentsWithMargin());
    std::vector<Vec3> corners;
    for (int corner = 0; corner < 8; ++corner)
        corners.push_back(Vec3(corner & 1 ? half.x() : -half.x(), corner & 2 ? half.y() : -half.y(),
                               corner & 4 ? half.z() : -half.z()));
    return corners;
}

std::vector<Vec3> hullPoints(const btConvexHullShape& hull) {
    std::vector<Vec3> points;
    for (int i = 0; i < hull.getNumPoints(); ++i) points.push_back(fromBullet(hull.getScaledPoint(i)));
    return points;
}

std::vector<Vec3> sampledHull(const btConvexShape& shape) {
    btShapeHull hull(&shape);
    hull.buildHull(0, 1);
    std::vector<Vec3> points;
    for (int i = 0; i < hull.numVertices(); ++i) points.push_back(fromBullet(hull.getVertexPointer()[i]));
    return points;
}

/// Adds the parts of `shape`, placed by `frame`; returns the name of the first shape that is not convex, or
/// nothing.
std::string addParts(const btCollisionShape& shape, const btTransform& frame, ConvexParts& parts) {
    if (shape.isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(shape);
        for (int i = 0; i < compound.getNumChildShapes(); ++i) {
            std::string trouble =
                addParts(*compound.getChildShape(i), frame * compound.getChildTransform(i), parts);
            if (!trouble.empty()) return trouble;
        }
        return {};
    }
    if (!shape.isConvex() || shape.isConvex2d()) return shape.getName();
    std::vector<Vec3> points;
    if (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE)
        points = hullPoints(static_cast<const btConvexHullShape&>(shape));
    else
        points = supportPoints(static_cast<const btConvexShape&>(shape));
    for (Vec3& point : points) point = fromBullet(frame * toBullet(point));
    parts.push_back(std::move(points));
    return {};
}

double largestRadius(const btMultiSphereShape& spheres) {
    btScalar radius = 0;
    for (int i = 0; i < spheres.getSphereCount(); ++i) radius = std::max(radius, spheres.getSphereRadius(i));
    return radius;
}

/// nullptr if the child is not known.
const btCollisionShape* partOf(const btCompoundShape& compound, int child) {
    const bool is_known = child >= 0 && child < compound.getNumChildShapes();
    return is_known ? compound.getChildShape(child) : nullptr;
}

}  // namespace

std::vector<Vec3> supportPoints(const btConvexShape& shape) {
    if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) return boxCorners(static_cast<const btBoxShape&>(shape));
    return sampledHull(shape);
}

Result<ConvexParts> convexParts(const btCollisionShape& shape) {
    ConvexParts parts;
    const std::string not_convex = addParts(shape, btTransform::getIdentity(), parts);
    if (!not_convex.empty())
        return Error{"the body's shape has a part of type " + not_convex +
                     ", which is not a convex solid; give it a compound of boxes, hulls or other convex "
                     "shapes, or make "
                     "an asset from its surface and use add()"};
    if (parts.empty())
        return Error{"the body's compound shape has no children; add convex shapes to it first"};
    return parts;
}

bool isScaled(const btCollisionShape& shape) {
    return shape.getLocalScaling() != btVector3(1, 1, 1);
}

btVector3 extentOf(const btCollisionObject& object) {
    btVector3 low, high;
    object.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
    return high - low;
}

double strikingRadius(const btCollisionShape& shape, int child) {
    switch (shape.getShapeType()) {
        case SPHERE_SHAPE_PROXYTYPE:
            return static_cast<const btSphereShape&>(shape).getRadius();
        case CAPSULE_SHAPE_PROXYTYPE:
            return static_cast<const btCapsuleShape&>(shape).getRadius();
        case CYLINDER_SHAPE_PROXYTYPE:
            return static_cast<const btCylinderShape&>(shape).getRadius();
        case MULTI_SPHERE_SHAPE_PROXYTYPE:
            return largestRadius(static_cast<const btMultiSphereShape&>(shape));
        case UNIFORM_SCALING_SHAPE_PROXYTYPE: {
            const auto& scaled = static_cast<const btUniformScalingShape&>(shape);
            return scaled.getUniformScalingFactor() * strikingRadius(*scaled.getChildShape(), -1);
        }
        case COMPOUND_SHAPE_PROXYTYPE: {
            const btCollisionShape* part = partOf(static_cast<const btCompoundShape&>(shape), child);
            return part ? strikingRadius(*part, -1) : 0;
        }
        default:
            return 0;
    }
}

double ballRadius(const btCollisionShape& shape, int child) {
    switch (shape.getShapeType()) {
        case SPHERE_SHAPE_PROXYTYPE:
        case CAPSULE_SHAPE_PROXYTYPE:
            return strikingRadius(shape, child);
        case COMPOUND_SHAPE_PROXYTYPE: {
            const btCollisionShape* part = partOf(static_cast<const btCompoundShape&>(shape), child);
            return part ? ballRadius(*part, -1) : 0;
        }
        default:
            return 0;
    }
}

}  // namespace sherd
