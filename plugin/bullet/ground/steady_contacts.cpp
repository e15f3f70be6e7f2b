#include "bullet/ground/steady_contacts.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bullet/fragments/birth_overlaps.h"
#include "bullet/ground/ground_contact.h"
#include "bullet/ground/ground_surface.h"
#include "bullet/ground/standing_contacts.h"
#include "bullet/shapes/missed_vertices.h"
#include "bullet/world/body_travel.h"
#include "bullet/world/extra_contacts.h"
#include "bullet/world/world_internals.h"

namespace sherd {

namespace {

constexpr btScalar fastest_push_m_s = btScalar(0.05);  // the solver adds its work to the energy
constexpr btScalar largest_reach = btScalar(0.5);      // of the fragment's radius
constexpr btScalar same_place = btScalar(0.01);        // of the breaking threshold
constexpr btScalar coming_down = btScalar(0.05);       // of a whole body's radius
// Of the height that a body falls by in a step: what a base is uneven by.
constexpr btScalar even = btScalar(0.125);

/// Whether a whole body may sink into the ground in a step. One that lies there is Bullet's, as are shapes of
/// the app's.
bool comesDown(const Breakable& whole, btScalar time_step_s) {
    constexpr btScalar resting_m_s = btScalar(0.01), resting_1_s = btScalar(0.1);  // as most bodies do
    if (!whole.ownedHere()) return false;
    const btRigidBody& body = *whole.body;
    const btVector3 &velocity = body.getLinearVelocity(), &turning = body.getAngularVelocity();
    if (velocity.length2() < resting_m_s * resting_m_s && turning.length2() < resting_1_s * resting_1_s)
        return false;
    const btScalar radius = radiusAboutOrigin(body);
    return (velocity.length() + radius * turning.length()) * time_step_s > coming_down * radius;
}

/// Whether bodies stand on it: it is not moved by them, or it is no piece and no lighter than they are.
bool carries(const btCollisionObject& ground, const btRigidBody& body, const SteadiedBodies& bodies) {
    if (ground.isStaticOrKinematicObject()) return true;
    const btRigidBody* carrier = btRigidBody::upcast(&ground);
    return carrier && !bodies.is_fragment(ground) && carrier->getInvMass() <= body.getInvMass();
}

/// What moves on such a body, and is held up where its vertices are; nullptr for other pairs. A whole body is
/// held up on what neither breaks nor gives way: whole ones in a stack are Bullet's.
const Breakable* steadiedOnGround(const btPersistentManifold& manifold, const SteadiedBodies& bodies,
                                  btScalar time_step_s) {
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const bool is_fixed_a = a.isStaticOrKinematicObject(), is_fixed_b = b.isStaticOrKinematicObject();
    if (is_fixed_a && is_fixed_b) return nullptr;
    const Breakable *of_a = bodies.breakables.of(a), *of_b = bodies.breakables.of(b);
    const bool are_fragments = of_a && of_b && of_a->isFragment() && of_b->isFragment();
    if (are_fragments && !is_fixed_a && !is_fixed_b) return nullptr;  // most of a heap's
    const auto stands = [&](const Breakable* own, const btCollisionObject& ground, bool breaks_and_moves) {
        if (!own || own->body->isStaticOrKinematicObject() || !own->body->isActive()) return false;
        if (!own->isFragment() && (breaks_and_moves || !comesDown(*own, time_step_s))) return false;
        return carries(ground, *own->body, bodies);
    };
    if (stands(of_a, b, of_b && !is_fixed_b)) return of_a;
    return stands(of_b, a, of_a && !is_fixed_a) ? of_b : nullptr;
}

/// Whether one may stay in the other, whose hulls close the hollow in which it lies.
bool isNested(const btPersistentManifold& manifold, const SteadiedBodies& bodies) {
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const auto is_hollow = [&](const btCollisionObject& object) {
        const Breakable* whole = bodies.breakables.of(object);
        return whole && !whole->isFragment() && whole->ownedHere() && whole->owned.shape->closes_hollows;
    };
    return (is_hollow(a) || is_hollow(b)) && bodies.overlaps.allows(a, b);
}

/// A world of bodies at rest has many contacts, none of which need be looked at.
bool anyIsSteadied(const BreakableRegistry& breakables, btScalar time_step_s) {
    const auto& all = breakables.all();
    return std::any_of(all.begin(), all.end(), [&](const auto& breakable) {
        return breakable->in_world && (breakable->isFragment() ||
                                       (breakable->body->isActive() && comesDown(*breakable, time_step_s)));
    });
}

btScalar radiusOf(const btRigidBody& body) {
    btVector3 centre;
    btScalar radius;
    body.getCollisionShape()->getBoundingSphere(centre, radius);
    return radius;
}

/// Takes the point that is furthest from all contacts there are out of `points`: support on a wide base. None
/// if all are where a contact is already.
std::optional<btManifoldPoint> takeMostDistant(std::vector<btManifoldPoint>& points,
                                               const btPersistentManifold& manifold) {
    const btScalar same = same_place * manifold.getContactBreakingThreshold();
    std::size_t best = points.size();
    btScalar furthest = same * same;
    for (std::size_t i = 0; i < points.size(); ++i) {
        btScalar nearest = BT_LARGE_FLOAT;
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            const btVector3 way =
                manifold.getContactPoint(p).m_positionWorldOnA - points[i].m_positionWorldOnA;
            nearest = std::min(nearest, way.length2());
        }
        if (nearest <= furthest) continue;
        furthest = nearest;
        best = i;
    }
    if (best == points.size()) return std::nullopt;
    const btManifoldPoint taken = points[best];
    points.erase(points.begin() + static_cast<long>(best));
    return taken;
}

void addMissedVertices(btPersistentManifold& manifold, btScalar reach) {
    if (manifold.getNumContacts() == MANIFOLD_CACHE_SIZE) return;
    const btTransform &of_a = manifold.getBody0()->getWorldTransform(),
                      &of_b = manifold.getBody1()->getWorldTransform();
    std::vector<btManifoldPoint> missed = missedVertices(manifold, of_a, of_b, {reach});
    while (manifold.getNumContacts() < MANIFOLD_CACHE_SIZE) {
        std::optional<btManifoldPoint> next = takeMostDistant(missed, manifold);
        if (!next) break;
        btManifoldPoint& point = *next;
        point.m_localPointA = of_a.invXform(point.m_positionWorldOnA);
        point.m_localPointB = of_b.invXform(point.m_positionWorldOnB);
        point.m_userPersistentData = nullptr;  // the other point's
        point.m_lifeTime = 0;
        manifold.addManifoldPoint(point);
    }
}

bool isDeeperThan(btScalar depth, const btPersistentManifold& manifold) {
    for (int p = 0; p < manifold.getNumContacts(); ++p)
        if (manifold.getContactPoint(p).getDistance() < -depth) return true;
    return false;
}

bool isSolidAndStill(const btCollisionObject& object) {
    return object.isStaticObject() && !isGroundSurface(object);
}

/// What is so deep in a solid that carries it that the solver moves it out without making it any faster is
/// left as it is: up to some decimetres at high speeds, and a piece would fall asleep on its way out, or fall
/// through. Triangles push to the side that less of a body is on.
void limitDepth(btPersistentManifold& manifold, btScalar deepest, const btContactSolverInfo& info,
                const SteadiedBodies& bodies) {
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const auto carries_fragment = [&](const btCollisionObject& ground, const btCollisionObject& body) {
        return bodies.breakables.isFragment(body) && !hasSurface(*ground.getCollisionShape()) &&
               carries(ground, *btRigidBody::upcast(&body), bodies);
    };
    const bool is_on_ground =
        isSolidAndStill(a) || isSolidAndStill(b) || carries_fragment(a, b) || carries_fragment(b, a);
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        btManifoldPoint& point = manifold.getContactPoint(p);
        const bool is_moved_out = info.m_splitImpulse && is_on_ground &&
                                  point.getDistance() <= info.m_splitImpulsePenetrationThreshold;
        if (!is_moved_out) point.setDistance(std::max(point.getDistance(), -deepest));
    }
}

/// The solver begins with the impulses of the step before. Those of an impact are of no use after it: where
/// many bodies touch, it does not get rid of them in its iterations, and what is left makes bodies faster.
void forgetImpacts(btPersistentManifold& manifold, btScalar time_step_s) {
    constexpr btScalar weights = 10;  // of both bodies, in a step
    btScalar weight = 0;
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()}) {
        const btRigidBody* body = btRigidBody::upcast(object);
        if (body && body->getInvMass() > 0) weight += body->getGravity().length() / body->getInvMass();
    }
    if (!(weight > 0)) return;
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        btManifoldPoint& point = manifold.getContactPoint(p);
        if (point.m_appliedImpulse > weights * weight * time_step_s)
            point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
    }
}

/// How fast a point of a body of that radius may come towards its ground, m/s.
btScalar fastestApproach(const btRigidBody& body, const btCollisionObject& ground, btScalar radius) {
    btVector3 carried(0, 0, 0), turned(0, 0, 0);
    if (const btRigidBody* carrier = btRigidBody::upcast(&ground)) {
        turned = carrier->getAngularVelocity();
        carried = carrier->getVelocityInLocalPoint(body.getCenterOfMassPosition() -
                                                   carrier->getCenterOfMassPosition());
    }
    return (body.getLinearVelocity() - carried).length() +
           radius * (body.getAngularVelocity() - turned).length();
}

void standOnGround(btDiscreteDynamicsWorld& world, const Breakable& breakable, const MovedSurfaces& moved,
                   btPersistentManifold& manifold) {
    const btRigidBody& body = *breakable.body;
    const bool is_a = &body == manifold.getBody0();
    const btCollisionObject& ground = is_a ? *manifold.getBody1() : *manifold.getBody0();
    const btScalar time_step_s = world.getSolverInfo().m_timeStep, radius = radiusOf(body);
    const btScalar speed = fastestApproach(body, ground, radius);
    const btScalar fall = body.getGravity().length() * time_step_s * time_step_s;
    // Without gravity a body may be held by other forces.
    const btScalar least = same_place * manifold.getContactBreakingThreshold();
    const btScalar reach = std::min(speed * time_step_s + fall, largest_reach * radius) + least;
    const btVector3 inside = ballOnItsSide(world, breakable, moved);
    if (!standOnEvenGround(world, manifold, is_a, inside, reach, std::max(even * fall, least)))
        addMissedVertices(manifold, reach);
}

}  // namespace

void steadyContacts(btDiscreteDynamicsWorld& world, const SteadiedBodies& bodies,
                    const std::function<bool(const btCollisionObject&)>& is_concerned) {
    const BreakableRegistry& breakables = bodies.breakables;
    const btContactSolverInfo& info = world.getSolverInfo();
    if (!anyIsSteadied(breakables, info.m_timeStep)) return;
    const btScalar deepest = fastest_push_m_s * info.m_timeStep / info.m_erp2;
    const std::vector<const btPersistentManifold*> foreseen = predictiveContacts(world);
    btDispatcher& dispatcher = *world.getDispatcher();
    const int count = dispatcher.getNumManifolds();  // without those that are added here
    for (int i = 0; i < count; ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() == 0 || isExtra(manifold)) continue;
        if (!is_concerned(*manifold.getBody0()) && !is_concerned(*manifold.getBody1())) continue;
        const Breakable* body = steadiedOnGround(manifold, bodies, info.m_timeStep);
        if (!body || std::find(foreseen.begin(), foreseen.end(), &manifold) != foreseen.end()) continue;
        if (isNested(manifold, bodies)) continue;
        if (dispatcher.needsResponse(manifold.getBody0(), manifold.getBody1()))
            standOnGround(world, *body, bodies.moved_ground, manifold);
    }
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (!breakables.isFragment(*manifold.getBody0()) && !breakables.isFragment(*manifold.getBody1()))
            continue;
        if (isDeeperThan(deepest, manifold)) limitDepth(manifold, deepest, info, bodies);
        forgetImpacts(manifold, info.m_timeStep);
    }
}

}  // namespace sherd
