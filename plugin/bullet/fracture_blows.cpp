// Blows that the app asks for, and what else waits for the end of a step.

#include <limits>

#include "bullet/applied_blow.h"
#include "bullet/body_swap.h"
#include "bullet/fracture_world_impl.h"
#include "bullet/world_internals.h"

namespace sherd {

Status FractureWorld::Impl::applyBlow(btRigidBody* body, const std::vector<Push>& pushes) {
    const Status asked = enqueueBlow(body, pushes, 0);
    if (asked && !insideStep()) finishBetweenSteps();
    return asked;
}

Status FractureWorld::Impl::enqueueBlow(btRigidBody* body, const std::vector<Push>& pushes, int explosion) {
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
    blows_.push_back({breakable->serial, body, pushes, explosion});
    return success();
}

/// Blows of an explosion, each on another body.
Result<int> FractureWorld::Impl::applyBlows(
    const std::vector<std::pair<btRigidBody*, std::vector<Push>>>& blows) {
    for (const auto& [body, pushes] : blows) {
        const Breakable* breakable = breakables_.find(body);
        if (const Status valid = checkPushes(pushes); !valid) return Error{valid.error()};
        if (!breakable) continue;
        if (const Status valid = checkSpeeds(*breakable, pushes); !valid) return Error{valid.error()};
    }
    ++explosions_;
    int struck = 0;
    for (const auto& [body, pushes] : blows)
        if (enqueueBlow(body, pushes, explosions_)) ++struck;
    if (!insideStep()) finishBetweenSteps();
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
        std::vector<QueuedBlow> together;
        do {
            together.push_back(std::move(blows_.front()));
            blows_.pop_front();
        } while (together.back().explosion > 0 && !blows_.empty() &&
                 blows_.front().explosion == together.back().explosion);
        carryOut(together, time_step_s);
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

/// The body that the blow is on by now, if that can be struck.
Breakable* FractureWorld::Impl::strikableTargetOf(const QueuedBlow& blow) const {
    Breakable* target = targetOf(blow);
    return target && isInWorld(world_, target->body) && target->canBeStruck() ? target : nullptr;
}

/// A blow by itself, or all of an explosion: first those on what is held, each by itself; then the others,
/// side by side, but those of an explosion on fragments when the budget has their turn.
void FractureWorld::Impl::carryOut(const std::vector<QueuedBlow>& blows, btScalar time_step_s) {
    std::vector<StruckBreakable> at_once, in_turn;
    for (const QueuedBlow& blow : blows) {
        Breakable* target = strikableTargetOf(blow);
        if (!target) continue;
        if (target->asset.solid()->isAnchored()) {
            carryOutOnHeld(*target, blow.pushes, time_step_s);
            continue;
        }
        const auto struck = timed(times_.steps.contacts, [&] { return asContacts(*target, blow.pushes); });
        push(*target->body, blow.pushes);
        if (!target->breaksAt(time_s_)) continue;
        (blow.explosion > 0 && target->isFragment() ? in_turn : at_once).push_back(struck);
    }
    replaceBroken(evaluateBlows(at_once, 0), time_step_s);
    if (in_turn.empty()) return;
    // Where Sherd's solver was replaced no step would end their waiting.
    const btScalar wait_by_s = decorator_.inPlace() ? world_.getSolverInfo().m_timeStep : btScalar(0);
    replaceBroken(evaluateBlows(in_turn, wait_by_s), time_step_s);
}

/// What is held takes no impulse itself; what comes loose of it does.
void FractureWorld::Impl::carryOutOnHeld(Breakable& held, const std::vector<Push>& pushes,
                                         btScalar time_step_s) {
    std::vector<Break> breaks;
    if (held.breaksAt(time_s_))
        breaks = evaluateBlows({timed(times_.steps.contacts, [&] { return asContacts(held, pushes); })}, 0);
    for (Break& broken : breaks) broken.pushes = &pushes;
    if (!replaceBroken(std::move(breaks), time_step_s)) push(*held.body, pushes);
}

/// Whether there are new bodies.
bool FractureWorld::Impl::replaceBroken(std::vector<Break> breaks, btScalar time_step_s) {
    bool is_any_new = false;
    for (Break& broken : breaks) {
        const auto fragments = swap(broken, time_step_s);
        if (fragments.empty()) continue;
        findNewContacts(fragments);
        is_any_new = true;
    }
    return is_any_new;
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
