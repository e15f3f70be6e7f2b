#include "bullet/strikes/met_on_the_way.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <optional>

#include "bullet/island/contact_motion.h"
#include "bullet/shapes/convex_part.h"
#include "bullet/shapes/shapes.h"
#include "bullet/world/conversions.h"

namespace sherd {

namespace {

constexpr btScalar closes = btScalar(0.5);   // of the speed: a contact that says how bodies meet
constexpr btScalar of_way = btScalar(0.1);   // depth over the way of a step, and
constexpr btScalar of_body = btScalar(0.1);  // over the smaller body: what is less slides along
constexpr btScalar sunk_m = btScalar(5e-3);  // bodies that rest or slide are no deeper in each other

btScalar smallestExtent(const btCollisionObject& object) {
    const btVector3 extent = extentOf(object);
    return extent[extent.minAxis()];
}

/// nullptr if it is not convex.
const btConvexShape* convex(const PlacedShape& placed) {
    return placed.shape && placed.shape->isConvex() ? static_cast<const btConvexShape*>(placed.shape)
                                                    : nullptr;
}

const btManifoldPoint& deepestOf(const btPersistentManifold& manifold) {
    int deepest = 0;
    for (int i = 1; i < manifold.getNumContacts(); ++i)
        if (manifold.getContactPoint(i).getDistance() < manifold.getContactPoint(deepest).getDistance())
            deepest = i;
    return manifold.getContactPoint(deepest);
}

/// Whether bodies that move against each other with `meeting` are too deep in each other, and come apart too
/// far from where they came from, for the manifold to say how they met.
bool isInDoubt(const btPersistentManifold& manifold, btScalar depth_m, const btVector3& meeting,
               double time_step_s) {
    const btScalar speed = meeting.length();
    const btScalar smallest =
        std::min(smallestExtent(*manifold.getBody0()), smallestExtent(*manifold.getBody1()));
    if (!(depth_m > of_way * btScalar(time_step_s) * speed && depth_m > of_body * smallest)) return false;
    for (int i = 0; i < manifold.getNumContacts(); ++i)
        if (meeting.dot(manifold.getContactPoint(i).m_normalWorldOnB) > closes * speed) return false;
    return true;
}

/// Where and how a shape that comes the `way` touches another one first.
struct Touch {
    btVector3 point, normal;  // on the other; out of the shape that comes
    btScalar left = 0;        // of the way, 0 to 1
};

std::optional<Touch> touchOf(const btConvexShape& shape, const btTransform& arrived, const btVector3& way,
                             const btConvexShape& other, const btTransform& other_stood) {
    btTransform from = arrived;
    from.setOrigin(arrived.getOrigin() - way);
    btVoronoiSimplexSolver simplex;
    btGjkConvexCast cast(&shape, &other, &simplex);
    btConvexCast::CastResult met;
    if (!cast.calcTimeOfImpact(from, arrived, other_stood, other_stood, met)) return std::nullopt;
    const bool touches_on_it = met.m_fraction > 0 && met.m_fraction < 1;
    if (!touches_on_it || !(met.m_normal.length2() > SIMD_EPSILON)) return std::nullopt;
    const btVector3 normal = met.m_normal.normalized();
    return Touch{met.m_hitPoint, way.dot(normal) < 0 ? btVector3(-normal) : normal, 1 - met.m_fraction};
}

}  // namespace

std::unique_ptr<btPersistentManifold> metOnTheWay(const btPersistentManifold& manifold,
                                                  const StepSnapshot& before, double time_step_s) {
    if (manifold.getNumContacts() == 0) return nullptr;
    btManifoldPoint point = deepestOf(manifold);
    if (!(-point.getDistance() > sunk_m)) return nullptr;
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const BodyState *state_a = before.find(&a), *state_b = before.find(&b);
    const btVector3 place = point.getPositionWorldOnA(), along = point.m_normalWorldOnB;
    const btVector3 meeting = motionAt(b, state_b, place, along, time_step_s).velocity -
                              motionAt(a, state_a, place, along, time_step_s).velocity;
    if (!isInDoubt(manifold, -point.getDistance(), meeting, time_step_s)) return nullptr;

    const auto stood = [](const btCollisionObject& object, const BodyState* state) {
        return state ? state->transform : object.getWorldTransform();
    };
    const PlacedShape part_a = childOf(a, stood(a, state_a), point.m_index0),
                      part_b = childOf(b, stood(b, state_b), point.m_index1);
    const btConvexShape *shape_a = convex(part_a), *shape_b = convex(part_b);
    if (!shape_a || !shape_b) return nullptr;
    const btVector3 way = btScalar(time_step_s) * meeting;
    const auto touch = touchOf(*shape_b, part_b.transform, way, *shape_a, part_a.transform);
    if (!touch || !(meeting.dot(touch->normal) > closes * meeting.length())) return nullptr;

    const btVector3 gone = touch->left * way;
    point.m_normalWorldOnB = touch->normal;
    point.m_positionWorldOnA = touch->point;
    point.m_positionWorldOnB = touch->point + gone;
    point.m_distance1 = -gone.dot(touch->normal);
    const Vec3 along_it = fromBullet(touch->normal);
    const auto felt = [&](const btCollisionObject& object, const btVector3& point) {
        const Mobility mobility = mobilityOf(object, btTransform::getIdentity(), point);
        return along_it.dot(mobility.at(fromBullet(point)) * along_it);
    };
    const double both = felt(a, point.m_positionWorldOnA) + felt(b, point.m_positionWorldOnB);
    point.m_appliedImpulse = both > 0 ? btScalar(meeting.dot(touch->normal) / both) : 0;
    point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
    auto found = std::make_unique<btPersistentManifold>(&a, &b, 0, manifold.getContactBreakingThreshold(),
                                                        manifold.getContactProcessingThreshold());
    found->addManifoldPoint(point);
    return found;
}

bool isSunkBeside(const btPersistentManifold& manifold, const std::vector<btPersistentManifold*>& all) {
    constexpr btScalar same_side = btScalar(0.9), as_deep = btScalar(0.5);
    const btManifoldPoint& own = deepestOf(manifold);
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    return std::any_of(all.begin(), all.end(), [&](const btPersistentManifold* other) {
        const btCollisionObject *c = other->getBody0(), *d = other->getBody1();
        const bool is_pair = (c == a && d == b) || (c == b && d == a);
        if (is_pair || (c != a && c != b && d != a && d != b)) return false;
        const btScalar side = c == a || d == b ? 1 : -1;  // of the other's normal, seen from the shared body
        for (int i = 0; i < other->getNumContacts(); ++i) {
            const btManifoldPoint& point = other->getContactPoint(i);
            if (side * point.m_normalWorldOnB.dot(own.m_normalWorldOnB) > same_side &&
                point.getDistance() < as_deep * own.getDistance())
                return true;
        }
        return false;
    });
}

}  // namespace sherd
