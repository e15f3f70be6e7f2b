#include "bullet/shapes/missed_vertices.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "bullet/shapes/convex_part.h"
#include "bullet/shapes/flat_face.h"

namespace sherd {

namespace {

/// The vertices of one of the two bodies.
class VerticesOf {
  public:
    VerticesOf(const btPersistentManifold& manifold, bool of_a, const btTransform& own_stood,
               const btTransform& other_stood, const WantedVertices& wanted)
        : manifold_(manifold),
          of_a_(of_a),
          own_(of_a ? *manifold.getBody0() : *manifold.getBody1()),
          other_(of_a ? *manifold.getBody1() : *manifold.getBody0()),
          own_stood_(own_stood),
          threshold_(manifold.getContactBreakingThreshold()),
          reach_(wanted.reach),
          part_(partOf(other_, other_stood, childOfOther())) {
        const PlacedShape part = childOf(other_, other_stood, childOfOther());
        const int type = part.shape ? part.shape->getShapeType() : INVALID_SHAPE_PROXYTYPE;
        is_plane_ = type == STATIC_PLANE_PROXYTYPE;
        is_box_ = type == BOX_SHAPE_PROXYTYPE;
        if (!wanted.on_hulls || is_plane_ || is_box_) return;
        // Beside a ridge between two faces one of them alone would be met.
        face_ = faceTowards(part, outwardAt(manifold.getContactPoint(0)));
        if (face_ && !face_->isUnder(childOf(own_, own_stood, childOfOwn()))) face_.reset();
    }

    /// `of_all_parts`: of all that the body consists of, if it lies on something flat; else of the part
    /// that the manifold is of.
    void addMissed(bool of_all_parts, std::vector<btManifoldPoint>& points) const {
        const btCollisionShape* shape = own_.getCollisionShape();
        if (!of_all_parts || !shape->isCompound() || !(is_plane_ || is_box_ || face_)) {
            addMissed(partOf(own_, own_stood_, childOfOwn()), points);
            return;
        }
        const int count = static_cast<const btCompoundShape*>(shape)->getNumChildShapes();
        for (int child = 0; child < count; ++child) addMissed(partOf(own_, own_stood_, child), points);
    }

  private:
    int childOfOwn() const {
        const btManifoldPoint& first = manifold_.getContactPoint(0);
        return of_a_ ? first.m_index0 : first.m_index1;
    }
    int childOfOther() const {
        const btManifoldPoint& first = manifold_.getContactPoint(0);
        return of_a_ ? first.m_index1 : first.m_index0;
    }

    void addMissed(const ConvexPart& part, std::vector<btManifoldPoint>& points) const {
        if (!part.shape) return;
        const btManifoldPoint& first = manifold_.getContactPoint(0);
        const btScalar margin = marginAround(*part.shape);
        const Planes planes = planesSeenFrom(part, margin);
        forEachVertex(*part.shape, [&](const btVector3& own) {
            if (isBeyond(planes, own)) return;
            const btVector3 vertex = part.transform * own;
            const btManifoldPoint* near = nearestPoint(vertex, isOverOrIn(first, vertex, margin));
            if (!near) return;
            const btManifoldPoint point = contactAt(*near, vertex, margin);
            if (point.getDistance() < reach_) points.push_back(point);
        });
    }

    /// Of all points of the manifold: normal, and the height up to which a vertex counts; in the part's
    /// frame, and side by side.
    struct Planes {
        using OfPoints = Eigen::Array<btScalar, MANIFOLD_CACHE_SIZE, 1>;
        OfPoints x = OfPoints::Zero(), y = x, z = x, height = OfPoints::Constant(-BT_LARGE_FLOAT);
    };

    Planes planesSeenFrom(const ConvexPart& part, btScalar margin) const {
        constexpr btScalar rounding = btScalar(1e-5);  // m
        Planes planes;
        for (int i = 0; i < manifold_.getNumContacts(); ++i) {
            const btManifoldPoint& point = manifold_.getContactPoint(i);
            const btVector3 outward = outwardAt(point);
            const btVector3 normal = outward * part.transform.getBasis();
            planes.x[i] = normal.x();
            planes.y[i] = normal.y();
            planes.z[i] = normal.z();
            planes.height[i] =
                outward.dot(onOther(point) - part.transform.getOrigin()) + margin + reach_ + rounding;
        }
        return planes;
    }

    /// Whether a vertex is too high over all of them, seen before it is placed in the world: most are.
    static bool isBeyond(const Planes& planes, const btVector3& vertex) {
        const Planes::OfPoints above =
            planes.x * vertex.x() + planes.y * vertex.y() + planes.z * vertex.z() - planes.height;
        return above.minCoeff() >= 0;  // in vector lanes, as any() is not
    }

    const btVector3& onOther(const btManifoldPoint& point) const {
        return of_a_ ? point.m_positionWorldOnB : point.m_positionWorldOnA;
    }
    const btVector3& onOwn(const btManifoldPoint& point) const {
        return of_a_ ? point.m_positionWorldOnA : point.m_positionWorldOnB;
    }

    /// Out of the other body.
    btVector3 outwardAt(const btManifoldPoint& point) const {
        return of_a_ ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
    }

    /// Whether a point lies in a plane's half-space, in a box, or below a face, as far as that is known.
    bool isInside(const btVector3& point) const {
        if (is_plane_) return true;
        if (is_box_) return part_.shape->isInside(part_.transform.invXform(point), part_.shape->getMargin());
        return face_ && face_->isUnder(point) && face_->above(point) < 0 &&
               face_->above(point) > -face_->thickness;
    }

    /// The same of a vertex, or where it is no further out than the reach, of the place below it.
    bool isOverOrIn(const btManifoldPoint& point, const btVector3& vertex, btScalar margin) const {
        constexpr btScalar below = 0.01;  // of the threshold: no thin box ends there
        const btVector3 outward = outwardAt(point);
        const btScalar height = outward.dot(vertex - onOther(point)) - margin;
        if (height >= reach_) return false;
        return isInside(vertex - outward * (margin + std::max(height, btScalar(0)) + below * threshold_));
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
        const btScalar distance = outward.dot(own - onOther(near));
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
    const btTransform& own_stood_;
    const btScalar threshold_, reach_;
    const ConvexPart part_;  // of the other one
    bool is_plane_ = false, is_box_ = false;
    std::optional<FlatFace> face_;
};

}  // namespace

bool isBetween(const btManifoldPoint& point, const std::vector<btManifoldPoint>& vertices,
               bool lands_on_face) {
    constexpr btScalar flat = btScalar(0.01);      // slope of the face against what it lands on
    constexpr btScalar parallel = btScalar(1e-5);  // sine of an angle that is none but for rounding
    constexpr btScalar opposite =
        btScalar(-0.999);  // cosine of the angle between ways to the ends of an edge
    if (vertices.size() < 2) return false;
    const btVector3& normal = point.m_normalWorldOnB;
    std::vector<btVector3> ways;
    ways.reserve(vertices.size());
    for (const btManifoldPoint& vertex : vertices) {
        const btVector3 way = vertex.m_positionWorldOnA - point.m_positionWorldOnA;
        if (way.fuzzyZero()) continue;
        if (vertex.getDistance() <= point.getDistance() + flat * way.length()) ways.push_back(way);
    }
    const auto isOpposite = [&](const btVector3& way) {
        return std::any_of(ways.begin(), ways.end(), [&](const btVector3& other) {
            return way.dot(other) < opposite * btSqrt(way.length2() * other.length2());
        });
    };
    if (lands_on_face && std::any_of(ways.begin(), ways.end(), isOpposite)) return true;
    if (ways.size() < 3) return false;
    // From each of them another one is less than half a turn further round the point.
    return std::all_of(ways.begin(), ways.end(), [&](const btVector3& way) {
        const btVector3 across = normal.cross(way);
        return std::any_of(ways.begin(), ways.end(), [&](const btVector3& other) {
            return across.dot(other) > parallel * btSqrt(across.length2() * other.length2());
        });
    });
}

std::vector<btManifoldPoint> missedVertices(const btPersistentManifold& manifold, const btTransform& stood_a,
                                            const btTransform& stood_b, const WantedVertices& wanted) {
    std::vector<btManifoldPoint> points;
    if (manifold.getNumContacts() == 0) return points;
    VerticesOf(manifold, true, stood_a, stood_b, wanted).addMissed(wanted.of_all_parts, points);
    VerticesOf(manifold, false, stood_b, stood_a, wanted).addMissed(wanted.of_all_parts, points);
    return points;
}

}  // namespace sherd
