#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

namespace sherd {

/// A convex part of a body, placed in the world; no shape if it has no vertices that Bullet knows.
struct ConvexPart {
    const btPolyhedralConvexShape* shape = nullptr;
    btTransform transform;
};

/// A shape of no parts, placed in the world; no shape if there is no such child.
struct PlacedShape {
    const btCollisionShape* shape = nullptr;
    btTransform transform;
};

/// `child`: of a compound, as contact points name it.
PlacedShape childOf(const btCollisionObject& object, btTransform transform, int child);

/// The same of polyhedra.
ConvexPart partOf(const btCollisionObject& object, btTransform transform, int child);

/// How far the surface that collides lies outside the vertices, m. Those of a box include the margin.
btScalar marginAround(const btPolyhedralConvexShape& shape);

/// In the frame of the part.
template <class Visit>
void forEachVertex(const btPolyhedralConvexShape& shape, const Visit& visit) {
    if (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE) {  // without a virtual call for each
        const auto& hull = static_cast<const btConvexHullShape&>(shape);
        for (int i = 0; i < hull.getNumPoints(); ++i) visit(hull.getScaledPoint(i));
        return;
    }
    for (int i = 0; i < shape.getNumVertices(); ++i) {
        btVector3 vertex;
        shape.getVertex(i, vertex);
        visit(vertex);
    }
}

}  // namespace sherd
