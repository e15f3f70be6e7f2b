#include "bullet/settled_pieces.h"

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <algorithm>
#include <vector>

#include "bullet/body_travel.h"
#include "bullet/other_joints.h"

extern btScalar gDeactivationTime;  // s; Bullet's

namespace sherd {

namespace {

// Of the radius: how far points of a piece may move. It is 5 mm/s at most that a piece of 10 cm creeps by.
constexpr btScalar while_it_settles = btScalar(0.1), while_it_rocks = btScalar(0.5);
// How long it takes until it is calmed, of sqrt(radius / gravity): in that a piece that stands on an edge
// falls over.
constexpr btScalar rocking = 10;
constexpr btScalar calming = 2;  // of the angle that it can fall over by in a step

/// Adds a step to how long a piece has been where it is, and returns that, s.
double timeInPlace(const btRigidBody& body, btScalar surroundings, double time_step_s,
                   Breakable::Stay& stay) {
    const btTransform& now = body.getWorldTransform();
    const btScalar radius = radiusAboutOrigin(body);
    if (body.isActive() && travel(stay.at, now, radius) <= surroundings * radius)
        return stay.time_s += time_step_s;
    stay.at = now;
    return stay.time_s = 0;
}

void letSleep(Breakable& piece, double time_step_s) {
    const double time_s = timeInPlace(*piece.body, while_it_settles, time_step_s, piece.settled);
    const bool may_sleep = !gDisableDeactivation && gDeactivationTime > 0;
    if (may_sleep && time_s > gDeactivationTime && piece.body->getActivationState() == ACTIVE_TAG)
        piece.body->setActivationState(WANTS_DEACTIVATION);
}

void calm(Breakable& piece, btScalar time_step_s) {
    btRigidBody& body = *piece.body;
    const btScalar gravity = body.getGravity().length(), radius = radiusAboutOrigin(body);
    if (!(gravity > 0)) return;
    const double time_s = timeInPlace(body, while_it_rocks, time_step_s, piece.rocking);
    if (time_s < rocking * btSqrt(radius / gravity)) return;
    const btScalar falls_by = gravity * time_step_s * time_step_s / radius;
    body.setAngularVelocity(body.getAngularVelocity() / (1 + calming * falls_by));
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
    for (const auto& breakable : breakables.all()) {
        if (!breakable->in_world || !breakable->isFragment() || !breakable->isDynamic()) continue;
        letSleep(*breakable, time_step_s);
        if (!std::binary_search(on_joints.begin(), on_joints.end(), breakable->body))
            calm(*breakable, static_cast<btScalar>(time_step_s));
    }
}

void forgetSettled(const BreakableRegistry& breakables) {
    for (const auto& breakable : breakables.all())
        if (breakable->in_world && breakable->isFragment() && !breakable->body->isActive())
            breakable->settled.time_s = breakable->rocking.time_s = 0;
}

}  // namespace sherd
