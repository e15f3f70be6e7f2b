#include "bullet/ground/ground_surface.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <vector>

#include "bullet/world/objects_around.h"
#include "bullet/world/pair_filter.h"

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
                   const btVector3& to, const MovedSurfaces& left_out)
        : ClosestRayResultCallback(from, to), world_(world), body_(body), left_out_(left_out) {}
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        const auto& object = *static_cast<btCollisionObject*>(proxy->m_clientObject);
        return isGroundFor(world_, body_, object) &&
               std::none_of(left_out_.begin(), left_out_.end(),
                            [&](const MovedSurface& surface) { return surface.ground == &object; });
    }

  private:
    btDiscreteDynamicsWorld& world_;
    const btRigidBody& body_;
    const MovedSurfaces& left_out_;
};

/// Whether a straight way comes into the box around an object.
bool reaches(const btCollisionObject& object, const btVector3& from, const btVector3& to) {
    const btBroadphaseProxy& proxy = *object.getBroadphaseHandle();
    btVector3 low = from, high = from;
    low.setMin(to);
    high.setMax(to);
    return TestAabbAgainstAabb2(low, high, proxy.m_aabbMin, proxy.m_aabbMax);
}

/// Of a way that hit something.
GroundPoint pointOf(const btCollisionWorld::ClosestRayResultCallback& way) {
    return {way.m_collisionObject, way.m_hitPointWorld, way.m_hitNormalWorld,
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
                                         const MovedSurfaces& moved) {
    std::optional<GroundPoint> first;
    btScalar first_fraction = 1;
    const auto include = [&](const btCollisionWorld::ClosestRayResultCallback& way) {
        if (!way.hasHit() || (first && way.m_closestHitFraction >= first_fraction)) return;
        first_fraction = way.m_closestHitFraction;
        first = pointOf(way);
    };
    if ((to - from).length2() > 0) {
        GroundOnTheWay way(world, body, from, to, moved);
        world.rayTest(from, to, way);
        include(way);
    }
    for (const MovedSurface& surface : moved) {
        const btVector3 start = surface.carry(from);
        if (!((to - start).length2() > 0) || !reaches(*surface.ground, start, to)) continue;
        if (!isGroundFor(world, body, *surface.ground)) continue;
        const btMatrix3x3 upright = btMatrix3x3::getIdentity();
        btCollisionWorld::ClosestRayResultCallback way(start, to);
        btCollisionWorld::rayTestSingle(btTransform(upright, start), btTransform(upright, to),
                                        const_cast<btCollisionObject*>(surface.ground),
                                        surface.ground->getCollisionShape(),
                                        surface.ground->getWorldTransform(), way);
        include(way);
    }
    return first;
}

btTransform moveOf(const std::optional<GroundPoint>& point, const MovedSurfaces& moved) {
    for (const MovedSurface& surface : moved)
        if (point && point->ground == surface.ground && surface.carry(point->point) != point->point)
            return surface.moved;
    return btTransform::getIdentity();
}

btVector3 onItsSide(btDiscreteDynamicsWorld& world, const btRigidBody& body, const btVector3& point,
                    const MovedSurfaces& moved) {
    if (moved.empty()) return point;
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
