#include "bullet/ground/settled_pieces.h"

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "bullet/ground/ground_surface.h"
#include "bullet/island/contact_motion.h"
#include "bullet/island/other_joints.h"
#include "bullet/world/body_travel.h"

extern btScalar gDeactivationTime;  // s; Bullet's

namespace sherd {

namespace {

// Of the radius: how far points of a piece may move. It is 5 mm/s at most that a piece of 10 cm creeps by.
constexpr btScalar while_it_settles = btScalar(0.1), while_it_rocks = btScalar(0.5),
                   while_it_turns = btScalar(1);  // its centre
// How long it takes until it is calmed, of sqrt(radius / gravity): in that a piece that stands on an edge
// falls over.
constexpr btScalar rocking = 10;
constexpr double patience = 2;              // with one that turns on and on: times Bullet's
constexpr btScalar calming = 2;             // of the angle that it can fall over by in a step
constexpr double usual_deactivation_s = 2;  // gDeactivationTime, as Bullet has it
constexpr btScalar shallow_m = btScalar(1e-3), deep_m = btScalar(3e-3);  // in the ground

/// Adds a step to how long a piece has been where it is, and returns that, s. `way`: how far it has come from
/// there, m.
double timeInPlace(const btRigidBody& body, btScalar way, btScalar surroundings, double time_step_s,
                   Breakable::Stay& stay) {
    if (body.isActive() && way <= surroundings) return stay.time_s += time_step_s;
    stay.at = body.getWorldTransform();
    return stay.time_s = 0;
}

double timeOfPoints(const btRigidBody& body, btScalar radius, btScalar surroundings, double time_step_s,
                    Breakable::Stay& stay) {
    const btScalar way = travel(stay.at, body.getWorldTransform(), radius);
    return timeInPlace(body, way, surroundings * radius, time_step_s, stay);
}

double timeOfCentre(const btRigidBody& body, btScalar radius, double time_step_s, Breakable::Stay& stay) {
    const btScalar way = (body.getCenterOfMassPosition() - stay.at.getOrigin()).length();
    return timeInPlace(body, way, while_it_turns * radius, time_step_s, stay);
}

/// Spins it less and less, if it rocks or turns on a spot.
void calm(Breakable& piece, btScalar radius, btScalar gravity, btScalar time_step_s) {
    btRigidBody& body = *piece.body;
    const double rocks_s = timeOfPoints(body, radius, while_it_rocks, time_step_s, piece.rocking),
                 turns_s = timeOfCentre(body, radius, time_step_s, piece.turning);
    const bool turns = gDeactivationTime > 0 && turns_s >= gDeactivationTime;
    if (!turns && rocks_s < rocking * btSqrt(radius / gravity)) return;
    const btScalar falls_by = gravity * time_step_s * time_step_s / radius;
    body.setAngularVelocity(body.getAngularVelocity() / (1 + calming * falls_by));
}

void settle(Breakable& piece, bool is_on_joint, double time_step_s) {
    btRigidBody& body = *piece.body;
    const btScalar radius = radiusAboutOrigin(body), gravity = body.getGravity().length();
    const double time_s = timeOfPoints(body, radius, while_it_settles, time_step_s, piece.settled);
    const bool may_be_calmed = gravity > 0 && !is_on_joint;
    if (may_be_calmed) calm(piece, radius, gravity, btScalar(time_step_s));
    const bool may_sleep = !gDisableDeactivation && gDeactivationTime > 0;
    const bool is_settled =
        time_s > gDeactivationTime || (may_be_calmed && piece.turning.time_s > patience * gDeactivationTime);
    if (may_sleep && is_settled && body.getActivationState() == ACTIVE_TAG)
        body.setActivationState(WANTS_DEACTIVATION);
}

/// A fragment in what does not give way.
struct SunkPiece {
    const btCollisionObject* piece = nullptr;
    btScalar depth = 0;  // of its deepest contact, m
    btVector3 out;       // unit
    bool is_still_solid = false;
};

/// One for each, sorted by their addresses.
std::vector<SunkPiece> sunkPieces(const btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables) {
    std::vector<SunkPiece> sunk;
    btDispatcher& dispatcher = *const_cast<btDiscreteDynamicsWorld&>(world).getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
        if (givesWay(*a) == givesWay(*b) || !dispatcher.needsResponse(a, b)) continue;
        const btCollisionObject& ground = givesWay(*a) ? *b : *a;
        SunkPiece found{givesWay(*a) ? a : b,
                        shallow_m,
                        {},
                        ground.isStaticObject() && !ground.isKinematicObject() && !isGroundSurface(ground)};
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            const btManifoldPoint& point = manifold.getContactPoint(p);
            if (!(-point.getDistance() > found.depth)) continue;
            found.depth = -point.getDistance();
            found.out = found.piece == a ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
        }
        if (found.depth > shallow_m && breakables.isFragment(*found.piece)) sunk.push_back(found);
    }
    std::stable_sort(sunk.begin(), sunk.end(), [](const SunkPiece& a, const SunkPiece& b) {
        return a.piece != b.piece ? std::less<>()(a.piece, b.piece) : a.depth > b.depth;
    });
    const auto same = [](const SunkPiece& a, const SunkPiece& b) { return a.piece == b.piece; };
    sunk.erase(std::unique(sunk.begin(), sunk.end(), same), sunk.end());
    return sunk;
}

/// Moves it out of the ground as fast as its contacts are let push it (steadyContacts), without a speed: what
/// lies on it and is heavier may push it in faster, since the solver does not converge there.
void lift(btRigidBody& body, const SunkPiece& sunk, double time_step_s) {
    constexpr btScalar speed_m_s = btScalar(0.05), steepest = btScalar(0.5);  // cosine
    const btScalar gravity = body.getGravity().length();
    if (!sunk.is_still_solid || !(gravity > 0) || sunk.out.dot(body.getGravity()) > -steepest * gravity)
        return;
    const btScalar way = std::min(sunk.depth - shallow_m, speed_m_s * btScalar(time_step_s));
    body.translate(way * sunk.out * body.getLinearFactor());
}

/// Bullet takes bodies out of the ground so slowly that they count as at rest: for as long as it takes by its
/// own time of deactivation, they do not.
void keepAwake(Breakable& piece, bool is_sunk, double time_step_s) {
    constexpr double recovers = 0.25;  // so that what goes in and out of it sleeps in the end, too
    piece.sunk_s =
        is_sunk ? piece.sunk_s + time_step_s : std::max(0.0, piece.sunk_s - recovers * time_step_s);
    if (!is_sunk || piece.sunk_s > usual_deactivation_s) return;
    piece.body->setDeactivationTime(0);
    piece.settled.time_s = piece.turning.time_s = 0;
}

/// Sorted.
std::vector<const btRigidBody*> bodiesOnJoints(const btDiscreteDynamicsWorld& world) {
    std::vector<const btRigidBody*> bodies;
    for (int i = 0; i < world.getNumConstraints(); ++i) {
        const btTypedConstraint& joint = *world.getConstraint(i);
        bodies.push_back(&joint.getRigidBodyA());
        bodies.push_back(&joint.getRigidBodyB());
    }
    if (const auto* multi = dynamic_cast<const btMultiBodyDynamicsWorld*>(&world))
        for (int i = 0; i < multi->getNumMultiBodyConstraints(); ++i)
            for (const btRigidBody* body : rigidBodiesOf(*multi->getMultiBodyConstraint(i)))
                bodies.push_back(body);
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}

}  // namespace

void settlePieces(const btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                  double time_step_s) {
    const std::vector<const btRigidBody*> on_joints = bodiesOnJoints(world);
    const bool sleep_early = gDeactivationTime < usual_deactivation_s;
    const std::vector<SunkPiece> all_sunk = sunkPieces(world, breakables);
    for (const auto& breakable : breakables.all()) {
        if (!breakable->in_world || !breakable->isFragment() || !breakable->isDynamic()) continue;
        btRigidBody* const body = breakable->body;
        const bool is_on_joint = std::binary_search(on_joints.begin(), on_joints.end(), body);
        const auto sunk = std::lower_bound(
            all_sunk.begin(), all_sunk.end(), body,
            [](const SunkPiece& a, const btCollisionObject* b) { return std::less<>()(a.piece, b); });
        const bool is_sunk = sunk != all_sunk.end() && sunk->piece == body;
        if (sleep_early) keepAwake(*breakable, is_sunk && sunk->depth > deep_m, time_step_s);
        if (is_sunk && !is_on_joint && body->isActive()) lift(*body, *sunk, time_step_s);
        settle(*breakable, is_on_joint, time_step_s);
    }
}

void forgetSettled(const BreakableRegistry& breakables) {
    for (const auto& breakable : breakables.all())
        if (breakable->in_world && breakable->isFragment() && !breakable->body->isActive())
            breakable->settled.time_s = breakable->rocking.time_s = breakable->turning.time_s =
                breakable->sunk_s = 0;
}

}  // namespace sherd
