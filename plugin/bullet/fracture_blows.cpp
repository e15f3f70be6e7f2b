// Blows that the app asks for, and what else waits for the end of a step.

#include <algorithm>
#include <utility>

#include "bullet/fracture_world_impl.h"
#include "bullet/fragments/body_swap.h"
#include "bullet/strikes/applied_blow.h"
#include "bullet/world/world_internals.h"

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
    requests_.add(AppRequests::Blow{breakable->serial, pushes, explosion});
    return success();
}

std::vector<std::pair<btRigidBody*, std::vector<Push>>> FractureWorld::Impl::pushesOnAll(
    const std::function<std::vector<Push>(const Breakable& body)>& pushes_on) {
    std::optional<AddedTime> whole, contacts;
    if (!insideStep()) {  // else it is part of what calls the app
        whole.emplace(times_.whole);
        contacts.emplace(times_.steps.contacts);
    }
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    const std::vector<const Breakable*> bodies = bodiesInWorld();
    std::vector<std::vector<Push>> pushes(bodies.size());
    const ThreadsAsAllowed threads(*this);
    forEachChunk(static_cast<int>(bodies.size()), [&](int i) { pushes[i] = pushes_on(*bodies[i]); });
    std::vector<std::pair<btRigidBody*, std::vector<Push>>> struck;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!pushes[i].empty()) struck.emplace_back(bodies[i]->body, std::move(pushes[i]));
    return struck;
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
    const int explosion = requests_.newExplosion();
    int struck = 0;
    for (const auto& [body, pushes] : blows)
        if (enqueueBlow(body, pushes, explosion)) ++struck;
    if (!insideStep()) finishBetweenSteps();
    return struck;
}

/// What waited for the end of the step, or of the blow that is applied between steps.
bool FractureWorld::Impl::hasWork() const {
    return !requests_.empty() || !log_.ofStep().empty() || !waiting_.empty();
}

void FractureWorld::Impl::finish(btScalar time_step_s) {
    if (!hasWork()) return;
    const InsideStep guard(world_);
    timed(times_.steps.sync, [&] { removeRequested(); });
    if (time_step_s > 0) {
        answerWaiting(time_step_s);
        timed(times_.steps.sync, [&] { removeRequested(); });  // by callbacks: the event still lists it
    }
    for (auto blows = requests_.takeBlows(); !blows.empty(); blows = requests_.takeBlows()) {
        carryOut(blows, time_step_s);
        timed(times_.steps.sync, [&] { removeRequested(); });
    }
    timed(times_.steps.sync, [&] { log_.endStep(); });
}

void FractureWorld::Impl::finishBetweenSteps() {
    spent_ = {};  // what the last step decided, and the pieces that it made, are done
    timed(times_.whole, [&] { finish(0); });
}

void FractureWorld::Impl::removeRequested() {
    while (const auto removal = requests_.takeRemoval()) removeNow(*removal);
}

/// A blow by itself, or all of an explosion: those are decided side by side, or when the budget has their
/// turn. What is held takes no impulse itself; what comes loose of it does.
void FractureWorld::Impl::carryOut(const std::vector<AppRequests::Blow>& blows, btScalar time_step_s) {
    const bool is_explosion = !blows.empty() && blows.front().explosion > 0;
    std::vector<StruckBreakable> together;
    for (const AppRequests::Blow& blow : blows)
        for (const auto& [body, pushes] : targetsOf(blow)) {
            if (!isInWorld(world_, body->body) || !body->canBeStruck()) continue;
            const auto struck = timed(times_.steps.contacts, [&, struck_body = body, by = &pushes] {
                return asContacts(*struck_body, *by);
            });
            const bool is_held = body->isHeld();
            if (!is_held) push(*body->body, pushes);
            if (!body->breaksAt(time_s_)) continue;
            together.push_back(struck);
            together.back().is_of_explosion = is_explosion;
            if (is_held) together.back().for_pieces = withSpeeds(*body, pushes);
        }
    // Where Sherd's solver was replaced no step would end their waiting.
    const bool may_wait = is_explosion && decorator_.inPlace();
    const btScalar wait_by_s = may_wait ? world_.getSolverInfo().m_timeStep : btScalar(0);
    replaceBroken(evaluateBlows(together, wait_by_s), time_step_s);
}

void FractureWorld::Impl::replaceBroken(std::vector<Break> breaks, btScalar time_step_s) {
    for (Break& broken : breaks)
        if (const auto fragments = swap(broken, time_step_s); !fragments.empty()) findNewContacts(fragments);
}

/// The body itself with all pushes; if it has broken since the blow was asked for, the fragments that are
/// nearest to each push; none if it was removed.
std::vector<std::pair<Breakable*, std::vector<Push>>> FractureWorld::Impl::targetsOf(
    const AppRequests::Blow& blow) const {
    for (const auto& breakable : breakables_.all())
        if (breakable->serial == blow.serial) return {{breakable.get(), blow.pushes}};
    std::vector<Breakable*> fragments;
    for (const QueuedEvent& queued : log_.ofStep()) {
        if (!queued.broken || queued.broken->serial != blow.serial) continue;
        for (const btRigidBody* body : queued.event.fragments)
            if (Breakable* fragment = breakables_.find(body)) fragments.push_back(fragment);
    }
    std::vector<std::pair<Breakable*, std::vector<Push>>> targets;
    if (fragments.empty()) return targets;
    for (const Push& push : blow.pushes) {
        std::vector<double> distances;
        for (const Breakable* fragment : fragments) distances.push_back(distanceTo(*fragment, push.point));
        const auto nearest = std::min_element(distances.begin(), distances.end()) - distances.begin();
        const auto known = std::find_if(targets.begin(), targets.end(), [&](const auto& target) {
            return target.first == fragments[nearest];
        });
        if (known != targets.end())
            known->second.push_back(push);
        else
            targets.push_back({fragments[nearest], {push}});
    }
    return targets;
}

}  // namespace sherd
