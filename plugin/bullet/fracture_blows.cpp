// Blows that the app asks for, and what else waits for the end of a step.

#include <limits>

#include "bullet/applied_blow.h"
#include "bullet/body_swap.h"
#include "bullet/fracture_world_impl.h"
#include "bullet/world_internals.h"

namespace sherd {

Status FractureWorld::Impl::applyBlow(btRigidBody* body, const std::vector<Push>& pushes) {
    if (const Status valid = checkPushes(pushes); !valid) return valid;
    if (!body) return Error{"there is no body to strike (nullptr)"};
    const Breakable* breakable = breakables_.find(body);
    if (!breakable) return Error{"the body is not breakable (it broke, was removed, or was never added)"};
    if (!breakable->being_born && !isInWorld(world_, body))
        return Error{"the body is not in this world; add it with addRigidBody first"};
    if (!breakable->canBeStruck())
        return Error{
            "the body is static or kinematic; only bodies that move, and static ones with supports, can "
            "break"};
    if (const Status valid = checkPlaces(*breakable, pushes); !valid) return valid;
    if (const Status valid = checkSpeeds(*breakable, pushes); !valid) return valid;
    blows_.push_back({breakable->serial, body, pushes});
    if (!insideStep()) finishBetweenSteps();
    return success();
}

/// Several blows of one cause, in turn. A callback of the app's may end them by destroying the FractureWorld.
Result<int> FractureWorld::Impl::applyBlows(
    const std::vector<std::pair<btRigidBody*, std::vector<Push>>>& blows) {
    for (const auto& [body, pushes] : blows) {
        const Breakable* breakable = breakables_.find(body);
        if (const Status valid = checkPushes(pushes); !valid) return Error{valid.error()};
        if (!breakable) continue;
        if (const Status valid = checkSpeeds(*breakable, pushes); !valid) return Error{valid.error()};
    }
    int struck = 0;
    for (const auto& [body, pushes] : blows)
        if (!released_ && applyBlow(body, pushes)) ++struck;
    return struck;
}

/// What waited for the end of the step, or of the blow that is applied between steps.
bool FractureWorld::Impl::hasWork() const {
    return !to_remove_.empty() || !blows_.empty() || !current_.empty() || !waiting_.empty();
}

void FractureWorld::Impl::finish(btScalar time_step_s) {
    if (!hasWork()) return;
    const InsideStep guard(world_);
    timed(times_.steps.sync, [&] { removeRequested(); });
    if (time_step_s > 0) answerWaiting(time_step_s);
    while (!blows_.empty()) {
        const QueuedBlow blow = std::move(blows_.front());
        blows_.pop_front();
        carryOut(blow, time_step_s);
        timed(times_.steps.sync, [&] { removeRequested(); });
    }
    const AddedTime time(times_.steps.sync);
    for (QueuedEvent& queued : current_) {
        times_.blows += queued.event.ms;
        times_.blows -= queued.elsewhere;
        times_.workers += queued.elsewhere;
        events_.push(std::move(queued));
    }
    current_.clear();
}

void FractureWorld::Impl::finishBetweenSteps() {
    timed(times_.whole, [&] { finish(0); });
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
    const auto struck = timed(times_.steps.contacts, [&] { return asContacts(*target, blow.pushes); });
    // What is held takes no impulse itself; what comes loose of it does.
    const bool held = target->asset.solid()->isAnchored();
    if (!held) push(*target->body, blow.pushes);
    std::vector<Break> breaks;
    if (target->breaksAt(time_s_)) breaks = evaluateBlows({struck}, 0);
    std::vector<btCollisionObject*> fragments;
    if (!breaks.empty()) {
        if (held) breaks.front().pushes = &blow.pushes;
        fragments = swap(breaks.front(), time_step_s);
    }
    if (held && fragments.empty()) push(*target->body, blow.pushes);
    if (fragments.empty()) return;
    findNewContacts(fragments);
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
