#include "bullet/ground_surface.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btAabbUtil2.h>

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

class GroundOnTheWay final : public btCollisionWorld::ClosestRayResultCallback {
  public:
    GroundOnTheWay(btDiscreteDynamicsWorld& world, const btRigidBody& body, const btVector3& from,
                   const btVector3& to)
        : ClosestRayResultCallback(from, to), world_(world), body_(body) {}
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return isGroundFor(world_, body_, *static_cast<btCollisionObject*>(proxy->m_clientObject));
    }

  private:
    btDiscreteDynamicsWorld& world_;
    const btRigidBody& body_;
};

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
    return object.isStaticObject() && hasSurface(*object.getCollisionShape());
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
    if (!((to - from).length2() > 0)) return std::nullopt;
    GroundOnTheWay way(world, body, from, to);
    world.rayTest(from, to, way);
    if (!way.hasHit()) return std::nullopt;
    return GroundPoint{way.m_collisionObject, way.m_hitPointWorld, way.m_hitNormalWorld,
                       (way.m_hitPointWorld - from).length()};
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
