#include "bullet/missed_vertices.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btPolyhedralConvexShape.h>

namespace sherd {

namespace {

/// A convex part of a body, placed in the world; no shape if it has no vertices that Bullet knows.
struct ConvexPart {
    const btPolyhedralConvexShape* shape = nullptr;
    btTransform transform;
};

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

/// How far the surface that collides lies outside the vertices, m. Those of a box include the margin.
btScalar marginAround(const btPolyhedralConvexShape& shape) {
    return shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? 0 : shape.getMargin();
}

/// The vertices of one of the two bodies.
class VerticesOf {
  public:
    VerticesOf(const btPersistentManifold& manifold, bool of_a, const btTransform& own_stood,
               const btTransform& other_stood, btScalar reach)
        : manifold_(manifold),
          of_a_(of_a),
          own_(of_a ? *manifold.getBody0() : *manifold.getBody1()),
          other_(of_a ? *manifold.getBody1() : *manifold.getBody0()),
          own_stood_(own_stood),
          other_stood_(other_stood),
          threshold_(manifold.getContactBreakingThreshold()),
          reach_(reach) {}

    void addMissed(std::vector<btManifoldPoint>& points) const {
        const btManifoldPoint& first = manifold_.getContactPoint(0);
        const ConvexPart part = partOf(own_, own_stood_, of_a_ ? first.m_index0 : first.m_index1);
        if (!part.shape) return;
        const ConvexPart other = partOf(other_, other_stood_, of_a_ ? first.m_index1 : first.m_index0);
        const btScalar margin = marginAround(*part.shape);
        for (int i = 0; i < part.shape->getNumVertices(); ++i) {
            btVector3 vertex;
            part.shape->getVertex(i, vertex);
            vertex = part.transform * vertex;
            const btVector3 within = vertex - outwardAt(first) * reach_;
            const btManifoldPoint* near = nearestPoint(vertex, isInside(other, within));
            if (!near) continue;
            const btManifoldPoint point = contactAt(*near, vertex, margin);
            if (point.getDistance() < reach_) points.push_back(point);
        }
    }

  private:
    const btVector3& onOwn(const btManifoldPoint& point) const {
        return of_a_ ? point.m_positionWorldOnA : point.m_positionWorldOnB;
    }

    /// Out of the other body.
    btVector3 outwardAt(const btManifoldPoint& point) const {
        return of_a_ ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
    }

    /// Whether a point lies in a plane's half-space or in a box, as far as that is known.
    bool isInside(const ConvexPart& part, const btVector3& point) const {
        if (other_.getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE) return true;
        return part.shape && part.shape->getShapeType() == BOX_SHAPE_PROXYTYPE &&
               part.shape->isInside(part.transform.invXform(point), part.shape->getMargin());
    }

    /// The manifold's point whose plane the vertex is held against; nullptr if the vertex is that point, or
    /// not inside and too far from all of them for one plane to be that of the other body.
    const btManifoldPoint* nearestPoint(const btVector3& vertex, bool inside) const {
        constexpr btScalar same = 0.01;  // of the threshold
        const btManifoldPoint* nearest = nullptr;
        btScalar least = inside ? BT_LARGE_FLOAT : threshold_ * threshold_;
        for (int i = 0; i < manifold_.getNumContacts(); ++i) {
            const btManifoldPoint& point = manifold_.getContactPoint(i);
            const btScalar distance = (onOwn(point) - vertex).length2();
            if (distance >= least) continue;
            nearest = &point;
            least = distance;
        }
        return least < same * same * threshold_ * threshold_ ? nullptr : nearest;
    }

    btManifoldPoint contactAt(const btManifoldPoint& near, const btVector3& vertex, btScalar margin) const {
        const btVector3 outward = outwardAt(near);
        const btVector3 own = vertex - margin * outward;
        const btVector3& plane = of_a_ ? near.m_positionWorldOnB : near.m_positionWorldOnA;
        const btScalar distance = outward.dot(own - plane);
        const btVector3 other = own - distance * outward;
        btManifoldPoint point = near;
        point.m_positionWorldOnA = of_a_ ? own : other;
        point.m_positionWorldOnB = of_a_ ? other : own;
        point.m_distance1 = distance;
        point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
        return point;
    }

    const btPersistentManifold& manifold_;
    const bool of_a_;
    const btCollisionObject &own_, &other_;
    const btTransform &own_stood_, &other_stood_;
    const btScalar threshold_, reach_;
};

}  // namespace

std::vector<btManifoldPoint> missedVertices(const btPersistentManifold& manifold, const btTransform& stood_a,
                                            const btTransform& stood_b, btScalar reach) {
    std::vector<btManifoldPoint> points;
    if (manifold.getNumContacts() == 0) return points;
    VerticesOf(manifold, true, stood_a, stood_b, reach).addMissed(points);
    VerticesOf(manifold, false, stood_b, stood_a, reach).addMissed(points);
    return points;
}

}  // namespace sherd
