// Blows that the app asks for, and what else waits for the end of a step.

#include <limits>

#include "bullet/applied_blow.h"
#include "bullet/body_swap.h"
#include "bullet/conversions.h"
#include "bullet/fracture_world_impl.h"
#include "bullet/world_internals.h"
#include "core/loads/load_patch.h"

namespace sherd {

namespace {

void push(btRigidBody& body, const std::vector<Push>& pushes) {
    if (body.isStaticOrKinematicObject()) return;
    body.activate();
    for (const Push& push : pushes)
        body.applyImpulse(push.impulse_n_s, push.point - body.getCenterOfMassPosition());
}

/// How far the surface is from a point of the world, m.
double distanceTo(const Breakable& breakable, const btVector3& point) {
    const Vec3 x = fromBullet(breakable.placed(breakable.body->getWorldTransform()).inverse() * point);
    return (nearestSurfacePoint(breakable.asset.surface(), x, Vec3::Zero()).point - x).norm();
}

}  // namespace

Status FractureWorld::Impl::applyBlow(btRigidBody* body, const std::vector<Push>& pushes) {
    if (const Status valid = checkPushes(pushes); !valid) return valid;
    const Breakable* breakable = breakables_.find(body);
    if (!breakable) return Error{"the body is not breakable; use add or makeBreakable first"};
    if (!isInWorld(world_, body))
        return Error{"the body is not in this world; add it with addRigidBody first"};
    if (!breakable->canBeStruck())
        return Error{
            "the body is static or kinematic; only bodies that move, and static ones with supports, can "
            "break"};
    blows_.push_back({breakable->serial, body, pushes});
    if (!insideStep()) finish(0);
    return success();
}

/// What waited for the end of the step, or of the blow that is applied between steps.
void FractureWorld::Impl::finish(btScalar time_step_s) {
    const InsideStep guard(world_);
    removeRequested();
    while (!blows_.empty()) {
        const QueuedBlow blow = std::move(blows_.front());
        blows_.pop_front();
        carryOut(blow, time_step_s);
        removeRequested();
    }
    for (QueuedEvent& queued : current_) events_.push(std::move(queued));
    current_.clear();
}

void FractureWorld::Impl::removeRequested() {
    while (!to_remove_.empty()) {
        const Removal removal = to_remove_.front();
        to_remove_.pop_front();
        removeNow(removal);
    }
}

void FractureWorld::Impl::carryOut(const QueuedBlow& blow, btScalar time_step_s) {
    Breakable* target = targetOf(blow);
    if (!target || !isInWorld(world_, target->body) || !target->canBeStruck()) return;
    const StruckBreakable struck = asContacts(*target, blow.pushes);
    push(*target->body, blow.pushes);
    if (!target->breaksAt(time_s_)) return;
    std::vector<Break> breaks = evaluateBlows({struck});
    if (breaks.empty()) return;
    const std::vector<btCollisionObject*> fragments = swap(breaks.front(), time_step_s);
    if (fragments.empty()) return;
    findContactsOf(world_, fragments);
    allowOverlapsAtBirth(fragments);
}

/// The body itself; the fragment that is nearest to the blow if the body has broken since the blow was asked
/// for; nullptr if it was removed.
Breakable* FractureWorld::Impl::targetOf(const QueuedBlow& blow) const {
    for (const auto& breakable : breakables_.all())
        if (breakable->serial == blow.serial) return breakable.get();
    Breakable* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const QueuedEvent& queued : current_) {
        if (!queued.broken || queued.broken->serial != blow.serial) continue;
        for (const btRigidBody* body : queued.event.fragments) {
            Breakable* fragment = breakables_.find(body);
            const double distance = fragment ? distanceTo(*fragment, blow.pushes.front().point) : least;
            if (!(distance < least)) continue;
            least = distance;
            nearest = fragment;
        }
    }
    return nearest;
}

}  // namespace sherd
