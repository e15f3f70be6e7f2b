#include "bullet/settled_pieces.h"

#include "bullet/body_travel.h"

extern btScalar gDeactivationTime;  // s; Bullet's

namespace sherd {

namespace {

/// Of the radius: how far points of a piece may move that stays where it is. It is 5 mm/s at most that a
/// piece of 10 cm creeps by.
constexpr btScalar surroundings = btScalar(0.1);

/// How long a piece has been where it is, s.
double timeInPlace(Breakable& piece, double time_step_s) {
    const btTransform& now = piece.body->getWorldTransform();
    const btScalar radius = radiusAboutOrigin(*piece.body);
    if (piece.body->isActive() && travel(piece.settled_at, now, radius) <= surroundings * radius)
        return piece.settled_for_s += time_step_s;
    piece.settled_at = now;
    return piece.settled_for_s = 0;
}

}  // namespace

void settlePieces(const BreakableRegistry& breakables, double time_step_s) {
    for (const auto& breakable : breakables.all()) {
        if (!breakable->in_world || !breakable->isFragment() || !breakable->isDynamic()) continue;
        const double time_s = timeInPlace(*breakable, time_step_s);
        btRigidBody& body = *breakable->body;
        const bool may_sleep = !gDisableDeactivation && gDeactivationTime > 0;
        if (may_sleep && time_s > gDeactivationTime && body.getActivationState() == ACTIVE_TAG)
            body.setActivationState(WANTS_DEACTIVATION);
    }
}

void forgetSettled(const BreakableRegistry& breakables) {
    for (const auto& breakable : breakables.all())
        if (breakable->in_world && breakable->isFragment() && !breakable->body->isActive())
            breakable->settled_for_s = 0;
}

}  // namespace sherd
