#include "bullet/fragments/continuous_collision.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>

#include "bullet/world/extra_contacts.h"
#include "bullet/world/pair_filter.h"
#include "bullet/world/world_internals.h"

namespace sherd {

namespace {

/// The first hit of a sweep. The rules are those of Bullet's own sweeps (btClosestNotMeConvexResultCallback).
class NearestHit final : public btCollisionWorld::ClosestConvexResultCallback {
  public:
    NearestHit(btDiscreteDynamicsWorld& world, btRigidBody& body, const btVector3& path)
        : ClosestConvexResultCallback(body.getWorldTransform().getOrigin(),
                                      body.getWorldTransform().getOrigin() + path),
          world_(world),
          body_(body) {
        m_collisionFilterGroup = body.getBroadphaseProxy()->m_collisionFilterGroup;
        m_collisionFilterMask = body.getBroadphaseProxy()->m_collisionFilterMask;
    }
    std::function<bool(const btCollisionObject&)> passes = [](const btCollisionObject&) { return false; };

    bool needsCollision(btBroadphaseProxy* proxy) const override {
        auto& other = *static_cast<btCollisionObject*>(proxy->m_clientObject);
        if (&other == &body_ || passes(other) || !ClosestConvexResultCallback::needsCollision(proxy))
            return false;
        return pushEachOther(world_, body_, other);
    }
    btScalar addSingleResult(btCollisionWorld::LocalConvexResult& result, bool in_world_frame) override {
        const btVector3 path = m_convexToWorld - m_convexFromWorld;
        if (result.m_hitNormalLocal.dot(path) >= -world_.getDispatchInfo().m_allowedCcdPenetration) return 1;
        return ClosestConvexResultCallback::addSingleResult(result, in_world_frame);
    }

  private:
    btDiscreteDynamicsWorld& world_;
    btRigidBody& body_;
};

/// The way of the centre in a step.
btVector3 pathOf(btRigidBody& body, btScalar time_step_s) {
    btTransform predicted;
    body.predictIntegratedTransform(time_step_s, predicted);
    return predicted.getOrigin() - body.getWorldTransform().getOrigin();
}

bool isSweptAlong(const btRigidBody& body, const btVector3& path) {
    const btScalar threshold = body.getCcdSquareMotionThreshold();
    return threshold != 0 && path.length2() > threshold;
}

/// Whether Bullet sweeps a body.
bool canBeSwept(const btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    return world.getDispatchInfo().m_useContinuous && body.getCcdSquareMotionThreshold() != 0 &&
           body.isActive() && !body.isStaticOrKinematicObject() && body.getCollisionShape()->isConvex();
}

bool isInTheWay(const btConvexShape& swept, const btTransform& from, const btVector3& path,
                const btCollisionObject& other) {
    btVector3 low, high;
    swept.getAabb(from, low, high);
    low.setMin(low + path);
    high.setMax(high + path);
    const btBroadphaseProxy& proxy = *other.getBroadphaseHandle();
    return TestAabbAgainstAabb2(low, high, proxy.m_aabbMin, proxy.m_aabbMax);
}

btTransform moved(const btTransform& from, const btVector3& path) {
    return btTransform(from.getBasis(), from.getOrigin() + path);
}

/// As Bullet makes its own: the points are as far off the other body's surface as the centre of the swept
/// sphere would be, which is where the contact is read from.
void addPredictiveContact(btDiscreteDynamicsWorld& world, btRigidBody& body, const NearestHit& hit,
                          const btVector3& path) {
    const btCollisionObject& other = *hit.m_hitCollisionObject;
    const btVector3 way = path * hit.m_closestHitFraction;
    const btVector3 there = hit.m_hitPointWorld + body.getCcdSweptSphereRadius() * hit.m_hitNormalWorld;
    const btVector3 origin = there - way;
    btPersistentManifold* manifold = world.getDispatcher()->getNewManifold(&body, &other);
    if (!manifold) return;  // its pool is full, and may not grow
    WorldInternals::predictiveManifolds(world).push_back(manifold);
    const btManifoldPoint point(body.getWorldTransform().inverse() * origin,
                                other.getWorldTransform().inverse() * there, hit.m_hitNormalWorld,
                                way.dot(-hit.m_hitNormalWorld));
    btManifoldPoint& added = manifold->getContactPoint(manifold->addManifoldPoint(point, true));
    added.m_combinedRestitution = 0;
    added.m_combinedFriction = gCalculateCombinedFrictionCallback(&body, &other);
    added.m_positionWorldOnA = origin;
    added.m_positionWorldOnB = there;
}

void releasePredictiveContactsOf(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    auto& manifolds = WorldInternals::predictiveManifolds(world);
    for (int i = manifolds.size() - 1; i >= 0; --i) {
        btPersistentManifold* manifold = manifolds[i];
        if (manifold->getBody0() != &body || isExtra(*manifold)) continue;
        manifolds.removeAtIndex(i);
        world.getDispatcher()->releaseManifold(manifold);
    }
}

}  // namespace

std::vector<btRigidBody*> sweptInto(btDiscreteDynamicsWorld& world,
                                    const std::function<bool(const btCollisionObject&)>& is_hit) {
    std::vector<btRigidBody*> bodies;
    const auto& manifolds = WorldInternals::predictiveManifolds(world);
    for (int i = 0; i < manifolds.size(); ++i) {
        if (isExtra(*manifolds[i])) continue;
        btRigidBody* body = btRigidBody::upcast(const_cast<btCollisionObject*>(manifolds[i]->getBody0()));
        const bool is_new = std::find(bodies.begin(), bodies.end(), body) == bodies.end();
        if (body && body->isInWorld() && is_new && is_hit(*manifolds[i]->getBody1())) bodies.push_back(body);
    }
    return bodies;
}

const btCollisionObject* predictContacts(btDiscreteDynamicsWorld& world, btRigidBody& body,
                                         const Obstacles& obstacles, btScalar time_step_s) {
    if (!body.isInWorld()) return nullptr;  // it broke, too
    releasePredictiveContactsOf(world, body);
    const btVector3 path = pathOf(body, time_step_s);
    if (!canBeSwept(world, body) || !isSweptAlong(body, path)) return nullptr;
    const btSphereShape sphere(body.getCcdSweptSphereRadius());
    const btTransform& from = body.getWorldTransform();

    NearestHit nearest(world, body, path);
    nearest.passes = [&](const btCollisionObject& other) {
        return obstacles.is_fragment(other) || obstacles.passes(other);
    };
    world.convexSweepTest(&sphere, from, moved(from, path), nearest);
    if (nearest.hasHit()) addPredictiveContact(world, body, nearest, path);

    // What flies through a body pushes what is in the way of all of it, as it does in steps that are shorter
    // than it, not only of the sphere within it. Where that sphere meets something, that says more of a body
    // which is not round than the one point of it that a sweep of its shape gives.
    const auto& shape = static_cast<const btConvexShape&>(*body.getCollisionShape());
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        btRigidBody* fragment = btRigidBody::upcast(objects[i]);
        if (!fragment || fragment == &body || !obstacles.is_fragment(*fragment)) continue;
        // Fragments move, too: many at nearly the same speed.
        const btVector3 relative = path - fragment->getLinearVelocity() * time_step_s;
        if (!isSweptAlong(body, relative) || !isInTheWay(shape, from, relative, *fragment)) continue;
        NearestHit hit(world, body, relative);
        hit.m_closestHitFraction = nearest.m_closestHitFraction;  // not beyond what stops the body before
        if (!hit.needsCollision(fragment->getBroadphaseHandle())) continue;
        const auto sweep = [&](const btConvexShape& swept) {
            btCollisionWorld::objectQuerySingle(&swept, from, moved(from, relative), fragment,
                                                fragment->getCollisionShape(), fragment->getWorldTransform(),
                                                hit, 0);
        };
        if (shape.getShapeType() != SPHERE_SHAPE_PROXYTYPE) sweep(sphere);
        if (!hit.m_hitCollisionObject) sweep(shape);
        if (hit.m_hitCollisionObject) addPredictiveContact(world, body, hit, relative);
    }
    return nearest.m_hitCollisionObject;
}

void SweepExceptions::begin(btDiscreteDynamicsWorld& world, const IsFragment& is_fragment,
                            btScalar time_step_s) {
    end();
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        btRigidBody* body = btRigidBody::upcast(objects[i]);
        if (!body || !canBeSwept(world, *body)) continue;
        const btVector3 path = pathOf(*body, time_step_s);
        if (!isSweptAlong(*body, path)) continue;
        const btSphereShape sphere(body->getCcdSweptSphereRadius());
        for (int k = 0; k < objects.size(); ++k) {
            if (k == i || !is_fragment(*objects[k]) ||
                !isInTheWay(sphere, body->getWorldTransform(), path, *objects[k]))
                continue;
            objects[k]->setIgnoreCollisionCheck(body, true);
            pairs_.emplace_back(objects[k], body);
        }
    }
}

void SweepExceptions::end() {
    for (const auto& [fragment, body] : pairs_) fragment->setIgnoreCollisionCheck(body, false);
    pairs_.clear();
}

}  // namespace sherd
