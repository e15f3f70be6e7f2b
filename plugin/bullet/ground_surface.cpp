#include "bullet/ground_surface.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <vector>

#include "bullet/objects_around.h"
#include "bullet/pair_filter.h"

namespace sherd {

namespace {

/// A plane is a half space: it pushes to one side wherever a body is.
bool isSurface(const btCollisionShape& shape) {
    return shape.isConcave() && shape.getShapeType() != STATIC_PLANE_PROXYTYPE;
}

/// Calls visit(surface, its frame) for each surface of a shape or of a compound of shapes.
template <class Visit>
void forEachSurface(const btCollisionShape& shape, const btTransform& frame, const Visit& visit) {
    if (isSurface(shape)) visit(static_cast<const btConcaveShape&>(shape), frame);
    if (!shape.isCompound()) return;
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    for (int i = 0; i < compound.getNumChildShapes(); ++i)
        forEachSurface(*compound.getChildShape(i), frame * compound.getChildTransform(i), visit);
}

bool isGroundFor(btDiscreteDynamicsWorld& world, const btRigidBody& body, const btCollisionObject& object) {
    return isGroundSurface(object) && pushEachOther(world, body, object);
}

/// `left_out`: ground that is not looked at.
class GroundOnTheWay final : public btCollisionWorld::ClosestRayResultCallback {
  public:
    GroundOnTheWay(btDiscreteDynamicsWorld& world, const btRigidBody& body, const btVector3& from,
                   const btVector3& to, const std::vector<MovedGround::Surface>& left_out)
        : ClosestRayResultCallback(from, to), world_(world), body_(body), left_out_(left_out) {}
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        const auto& object = *static_cast<btCollisionObject*>(proxy->m_clientObject);
        return isGroundFor(world_, body_, object) &&
               std::none_of(left_out_.begin(), left_out_.end(),
                            [&](const MovedGround::Surface& surface) { return surface.ground == &object; });
    }

  private:
    btDiscreteDynamicsWorld& world_;
    const btRigidBody& body_;
    const std::vector<MovedGround::Surface>& left_out_;
};

std::optional<GroundPoint> pointOf(const btCollisionWorld::ClosestRayResultCallback& way) {
    if (!way.hasHit()) return std::nullopt;
    return GroundPoint{way.m_collisionObject, way.m_hitPointWorld, way.m_hitNormalWorld,
                       (way.m_hitPointWorld - way.m_rayFromWorld).length()};
}

/// The point of some triangles that is nearest to another.
class NearestPoint final : public btTriangleCallback {
  public:
    NearestPoint(const btVector3& from, btScalar radius) : from_(from), squared_distance(radius * radius) {}
    void processTriangle(btVector3* corners, int, int) override {
        const btVector3 here = nearestOf({corners[0], corners[1], corners[2]}, from_);
        const btScalar squared = (here - from_).length2();
        if (!(squared < squared_distance)) return;
        squared_distance = squared;
        point = here;
        found = true;
    }

  private:
    btVector3 from_;

  public:
    btScalar squared_distance;
    btVector3 point = btVector3(0, 0, 0);
    bool found = false;
};

class EachTriangle final : public btTriangleCallback {
  public:
    EachTriangle(const btTransform& frame, const std::function<void(const std::array<btVector3, 3>&)>& visit)
        : frame_(frame), visit_(visit) {}
    void processTriangle(btVector3* corners, int, int) override {
        visit_({frame_ * corners[0], frame_ * corners[1], frame_ * corners[2]});
    }

  private:
    const btTransform& frame_;
    const std::function<void(const std::array<btVector3, 3>&)>& visit_;
};

}  // namespace

bool hasSurface(const btCollisionShape& shape) {
    bool found = false;
    forEachSurface(shape, btTransform::getIdentity(), [&](const auto&, const auto&) { found = true; });
    return found;
}

bool isGroundSurface(const btCollisionObject& object) {
    return object.isStaticOrKinematicObject() && hasSurface(*object.getCollisionShape());
}

bool isOnTriangle(const btManifoldPoint& point, bool of_second) {
    return (of_second ? point.m_partId1 : point.m_partId0) >= 0;  // Bullet's number of a part of a mesh
}

bool hasGroundSurface(const btDiscreteDynamicsWorld& world) {
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (isGroundSurface(*objects[i])) return true;
    return false;
}

btVector3 nearestOf(const std::array<btVector3, 3>& corners, const btVector3& to) {
    btVoronoiSimplexSolver solver;
    btSubSimplexClosestResult nearest;
    solver.closestPtPointTriangle(to, corners[0], corners[1], corners[2], nearest);
    return nearest.m_closestPointOnSimplex;
}

void forEachTriangle(const btCollisionObject& ground, const btVector3& low, const btVector3& high,
                     const std::function<void(const std::array<btVector3, 3>&)>& visit) {
    forEachSurface(*ground.getCollisionShape(), ground.getWorldTransform(),
                   [&](const btConcaveShape& surface, const btTransform& frame) {
                       EachTriangle each(frame, visit);
                       btVector3 own_low, own_high;
                       btTransformAabb(low, high, 0, frame.inverse(), own_low, own_high);
                       surface.processAllTriangles(&each, own_low, own_high);
                   });
}

std::optional<GroundPoint> groundBetween(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                         const btVector3& from, const btVector3& to) {
    return groundCrossed(world, body, from, to, {});
}

std::optional<GroundPoint> groundCrossed(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                         const btVector3& from, const btVector3& to,
                                         const std::vector<MovedGround::Surface>& moved) {
    if ((to - from).length2() > 0) {
        GroundOnTheWay way(world, body, from, to, moved);
        world.rayTest(from, to, way);
        if (way.hasHit()) return pointOf(way);
    }
    constexpr btScalar furthest = btScalar(0.5);  // m; what is further from where it was did not go there
    for (const MovedGround::Surface& surface : moved) {
        if (!isGroundFor(world, body, *surface.ground)) continue;
        const btVector3 start = surface.moved * from;
        if (!((to - start).length2() > 0) || (start - from).length2() > furthest * furthest) continue;
        const btTransform upright = btTransform::getIdentity();
        btCollisionWorld::ClosestRayResultCallback way(start, to);
        btCollisionWorld::rayTestSingle(
            btTransform(upright.getBasis(), start), btTransform(upright.getBasis(), to),
            const_cast<btCollisionObject*>(surface.ground), surface.ground->getCollisionShape(),
            surface.ground->getWorldTransform(), way);
        if (way.hasHit()) return pointOf(way);
    }
    return std::nullopt;
}

btTransform moveOf(const std::optional<GroundPoint>& point, const std::vector<MovedGround::Surface>& moved) {
    for (const MovedGround::Surface& surface : moved)
        if (point && point->ground == surface.ground) return surface.moved;
    return btTransform::getIdentity();
}

btVector3 onItsSide(btDiscreteDynamicsWorld& world, const btRigidBody& body, const btVector3& point,
                    const std::vector<MovedGround::Surface>& moved) {
    return moveOf(groundCrossed(world, body, point, point, moved), moved) * point;
}

std::optional<GroundPoint> groundNear(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                      const btVector3& from, btScalar radius) {
    const btVector3 reach(radius, radius, radius);
    std::optional<GroundPoint> nearest;
    for (const btCollisionObject* object : objectsAround(world, from - reach, from + reach)) {
        if (!isGroundFor(world, body, *object)) continue;
        forEachSurface(
            *object->getCollisionShape(), object->getWorldTransform(),
            [&](const btConcaveShape& surface, const btTransform& frame) {
                const btVector3 local = frame.invXform(from);
                NearestPoint here(local, nearest ? nearest->distance : radius);
                surface.processAllTriangles(&here, local - reach, local + reach);
                if (!here.found || !(here.squared_distance > 0)) return;
                const btVector3 point = frame * here.point;
                nearest = GroundPoint{object, point, (from - point).normalized(), (from - point).length()};
            });
    }
    return nearest;
}

}  // namespace sherd
