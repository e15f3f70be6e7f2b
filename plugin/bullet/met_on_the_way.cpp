#include "bullet/met_on_the_way.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>

#include "bullet/contact_motion.h"

namespace sherd {

namespace {

constexpr btScalar closes = btScalar(0.5);   // of the speed: a contact that says how bodies meet
constexpr btScalar of_way = btScalar(0.25);  // depth over the way of a step, and
constexpr btScalar of_body = btScalar(0.1);  // over the smaller body: what is less slides along
constexpr btScalar sunk_m = btScalar(5e-3);  // bodies that rest or slide are no deeper in each other

/// A convex part of a body; no shape if it is not convex.
struct Part {
    const btConvexShape* shape = nullptr;
    btTransform transform;
};

Part partOf(const btCollisionObject& object, btTransform transform, int child) {
    const btCollisionShape* shape = object.getCollisionShape();
    if (shape->isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(*shape);
        if (child < 0 || child >= compound.getNumChildShapes()) return {};
        shape = compound.getChildShape(child);
        transform = transform * compound.getChildTransform(child);
    }
    if (!shape->isConvex()) return {};
    return {static_cast<const btConvexShape*>(shape), transform};
}

btScalar smallestExtent(const btCollisionObject& object) {
    btVector3 low, high;
    object.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
    const btVector3 extent = high - low;
    return extent[extent.minAxis()];
}

const btManifoldPoint& deepestOf(const btPersistentManifold& manifold) {
    int deepest = 0;
    for (int i = 1; i < manifold.getNumContacts(); ++i)
        if (manifold.getContactPoint(i).getDistance() < manifold.getContactPoint(deepest).getDistance())
            deepest = i;
    return manifold.getContactPoint(deepest);
}

}  // namespace

std::unique_ptr<btPersistentManifold> metOnTheWay(const btPersistentManifold& manifold,
                                                  const StepSnapshot& before, double time_step_s) {
    if (manifold.getNumContacts() == 0) return nullptr;
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const BodyState *state_a = before.find(&a), *state_b = before.find(&b);
    const btManifoldPoint& deepest = deepestOf(manifold);
    const btScalar depth = -deepest.getDistance();
    if (!(depth > sunk_m)) return nullptr;
    const auto velocityOf = [&](const btCollisionObject& object, const BodyState* state) {
        return motionAt(object, state, deepest.getPositionWorldOnA(), deepest.m_normalWorldOnB, time_step_s)
            .velocity;
    };
    const btVector3 meeting = velocityOf(b, state_b) - velocityOf(a, state_a);
    const btScalar speed = meeting.length();
    const btVector3 way = btScalar(time_step_s) * meeting;
    if (!(depth > of_way * way.length())) return nullptr;
    for (int i = 0; i < manifold.getNumContacts(); ++i)
        if (meeting.dot(manifold.getContactPoint(i).m_normalWorldOnB) > closes * speed) return nullptr;
    if (!(depth > of_body * std::min(smallestExtent(a), smallestExtent(b)))) return nullptr;

    const Part part_a = partOf(a, state_a ? state_a->transform : a.getWorldTransform(), deepest.m_index0),
               part_b = partOf(b, state_b ? state_b->transform : b.getWorldTransform(), deepest.m_index1);
    if (!part_a.shape || !part_b.shape) return nullptr;
    btTransform from = part_b.transform;
    from.setOrigin(from.getOrigin() - way);
    btVoronoiSimplexSolver simplex;
    btGjkConvexCast cast(part_b.shape, part_a.shape, &simplex);
    btConvexCast::CastResult met;
    if (!cast.calcTimeOfImpact(from, part_b.transform, part_a.transform, part_a.transform, met))
        return nullptr;
    if (!(met.m_fraction > 0 && met.m_fraction < 1) || !(met.m_normal.length2() > SIMD_EPSILON))
        return nullptr;
    btVector3 normal = met.m_normal.normalized();
    if (meeting.dot(normal) < 0) normal = -normal;
    const btScalar closing = meeting.dot(normal);
    if (!(closing > closes * speed)) return nullptr;

    btManifoldPoint point = deepest;
    const btVector3 gone = (1 - met.m_fraction) * way;
    point.m_normalWorldOnB = normal;
    point.m_positionWorldOnA = met.m_hitPoint;
    point.m_positionWorldOnB = met.m_hitPoint + gone;
    point.m_distance1 = -gone.dot(normal);
    point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
    auto found = std::make_unique<btPersistentManifold>(&a, &b, 0, manifold.getContactBreakingThreshold(),
                                                        manifold.getContactProcessingThreshold());
    found->addManifoldPoint(point);
    return found;
}

}  // namespace sherd
