// What a FractureWorld does in a step of Bullet's, and where it is:
//   beforeSolve       contacts of fragments are steadied, velocities noted: ground/steady_contacts,
//                     island/island_state
//   (Bullet solves)
//   afterSolve        struck: what was struck, and how hard: strikes/contact_collector
//                     evaluateBlows: the gate; now, later, or dropped: fracture_decisions, schedule/patience
//                     resolveIslands: broken bodies become fragments, and Bullet solves their islands once
//                     more with them: fracture_resolve, fragments/body_swap
//   endSolve          finish: what the app asked for, blows whose turn it is: fracture_blows,
//                     fracture_waiting
//   (Bullet integrates)
//   afterIntegration  what has crossed ground is set back; looks ahead: ground/ground_contact,
//                     fracture_foresight

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "bullet/fracture_world_impl.h"
#include "bullet/ground/ground_contact.h"
#include "bullet/ground/ground_surface.h"
#include "bullet/ground/quiet_step.h"
#include "bullet/ground/settled_pieces.h"
#include "bullet/ground/steady_contacts.h"
#include "bullet/world/extra_contacts.h"

namespace sherd {

namespace {

constexpr int most_rounds = 8;  // of breaks in one step

}  // namespace

// `times_.whole` is measured here, and in `finishBetweenSteps`: these are all the ways in from outside.

void FractureWorld::Impl::beforeSolve() {
    spent_ = {};
    write_back_.end(world_);  // where the app was called in the last step, and has thrown
    const bool was_awake = std::exchange(awake_, anythingAwake(world_));
    // The clock would take more time than a world asleep does.
    if (!awake_ && !was_awake && !integrating_ && to_delete_.empty() && !log_.hasReleased()) return;
    timed(times_.whole, [&] { prepareSolve(); });
    solve_watch_ = {};
}

void FractureWorld::Impl::afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) {
    if (awake_) times_.bullet_solve += solve_watch_.milliseconds();
    time_s_ += info.m_timeStep;
    if (!any_breakable_) return;
    const AddedTime whole(times_.whole);
    solveBreaks(info, drawer);
    timed(times_.steps.snapshot, [&] { write_back_.end(world_); });
    any_breakable_ = false;
}

void FractureWorld::Impl::endSolve(const btContactSolverInfo& info) {
    releaseExtraManifolds(world_);
    if (awake_ || hasWork())
        timed(times_.whole, [&] {
            finish(info.m_timeStep);
            if (!awake_) return;
            const AddedTime time(times_.steps.sweep);
            sweep_exceptions_.begin(
                world_, [&](const auto& object) { return isFragment(object); }, info.m_timeStep);
        });
    integrating_ = true;
    if (released_)
        delete this;
    else if (!world_calls_actions_)
        afterIntegration();
}

void FractureWorld::Impl::afterIntegration() {
    if (awake_ || !decorator_.inPlace()) timed(times_.whole, [&] { tellWhatCannotBreak(); });
    if (awake_ || hasWork())
        timed(times_.whole, [&] {
            if (awake_) {
                if (breakables_.anyFragmentInWorld()) forgetSettled(breakables_);
                timed(times_.steps.ground,
                      [&] { stopAtGround(world_, breakables_, before_, moved_ground_); });
            }
            endIntegration();
        });
    integrating_ = false;
    markBetweenSteps(world_);
    if (!released_ && (awake_ || !foresight_.empty()))
        timed(times_.whole, [&] {
            lookAhead();
            const ThreadsAsAllowed threads(*this);
            if (mayHaveThreads())
                foresight_.keepUp(time_s_, world_.getSolverInfo().m_timeStep, budget_.solves_per_step,
                                  times_.steps.waiting);
            else
                foresight_.workUntil(time_s_);
        });
    deleteIfReleased();
}

void FractureWorld::Impl::endIntegration() {
    integrating_ = false;
    timed(times_.steps.sweep, [&] { sweep_exceptions_.end(); });
    finish(0);
}

void FractureWorld::Impl::prepareSolve() {
    StepTimes& ms = times_.steps;
    if (!to_delete_.empty() || log_.hasReleased())
        timed(ms.release, [&] {
            to_delete_.clear();
            log_.deleteReleased();
        });
    if (integrating_) {  // the world went on without calling its actions
        world_calls_actions_ = false;
        endIntegration();
    }
    any_breakable_ = false;
    if (!awake_) {
        before_.clear();
        return;
    }
    timed(ms.sync, [&] {
        breakables_.dropReplaced(world_.getCollisionObjectArray());
        breakables_.syncWithWorld(world_.getCollisionObjectArray());
        any_breakable_ = breakables_.anyInWorld();
    });
    if (!any_breakable_) return;
    moved_ground_.beginStep(world_);
    timed(ms.overlaps, [&] {
        if (std::exchange(any_just_added_, false)) allowOverlapsOfAdded();
        birth_overlaps_.applyAllowances(world_);
        if (breakables_.anyFragmentInWorld())  // while contacts are as deep as they are
            settlePieces(world_, breakables_, world_.getSolverInfo().m_timeStep);
        steadyContacts(world_, steadiedBodies(), [](const btCollisionObject&) { return true; });
    });
    timed(ms.ground, [&] {
        if (hasGroundSurface(world_)) addGroundContacts(world_, bodiesInWorld(), moved_ground_.surfaces());
    });
    const AddedTime time(ms.snapshot);
    any_breakable_ = !nothingCanBreak(world_, breakables_, world_.getSolverInfo().m_timeStep);
    if (any_breakable_) {
        before_.take(world_);
        write_back_.begin(world_);
    } else {
        before_.takeBodies(world_);
    }
}

/// Plates in a stack, cups in each other: their hulls close hollows in which others lie, and Bullet would
/// push them apart, hard enough to break them. Each body is looked at once, in the first step in which Bullet
/// does.
void FractureWorld::Impl::allowOverlapsOfAdded() {
    std::unordered_set<const btCollisionObject*> added;
    for (const auto& breakable : breakables_.all()) {
        if (!breakable->just_added) continue;
        if (breakable->in_world && (breakable->body->isActive() || breakable->body->isStaticObject())) {
            breakable->just_added = false;
            added.insert(breakable->body);
        } else {
            any_just_added_ = true;
        }
    }
    const auto isHollow = [&](const btCollisionObject& object) {
        const Breakable* breakable = breakables_.of(object);
        return breakable && breakable->ownedHere() && breakable->owned.shape->closes_hollows;
    };
    birth_overlaps_.addOverlapping(world_, [&](const auto& a, const auto& b) {
        return (added.count(&a) > 0 || added.count(&b) > 0) && (isHollow(a) || isHollow(b));
    });
}

/// What breaks in the step, and what is struck through it: a body with continuous collision may go through
/// several bodies in one step.
void FractureWorld::Impl::solveBreaks(const btContactSolverInfo& info, btIDebugDraw* drawer) {
    std::vector<Break> breaks;
    const auto swept = timed(times_.steps.sweep, [&] {
        return sweptInto(world_, [&](const auto& object) { return isFragmentOfAny(object); });
    });
    if (!swept.empty()) resolveIslands(breaks, swept, false, info, drawer);
    breaks = evaluateBlows(struck(info), info.m_timeStep);
    bool rests = false;  // whether supports may still hold pieces of what broke
    for (int round = 1; !breaks.empty(); ++round) {
        const auto is_broken = [&](const auto& object) {
            return std::any_of(breaks.begin(), breaks.end(),
                               [&](const Break& broken) { return broken.body == &object; });
        };
        const auto through = timed(times_.steps.sweep, [&] { return sweptInto(world_, is_broken); });
        const auto next = resolveIslands(breaks, through, round == most_rounds, info, drawer);
        rests = rests || anyWasHeld(breaks);
        const bool look_at_rests = rests && round < most_rounds;
        std::vector<StruckBreakable> blows;
        if (!next.empty() || look_at_rests)
            for (StruckBreakable& blow : struck(info)) {
                const Breakable& body = *blow.breakable;
                const bool is_swept = std::find(next.begin(), next.end(), body.body) != next.end();
                if (is_swept || (look_at_rests && body.isHeldRest() && !wasDecided(body)))
                    blows.push_back(std::move(blow));
            }
        breaks = evaluateBlows(blows, info.m_timeStep);
    }
}

/// Whether supports held something that broke: what goes on through it is about to strike what they still
/// hold.
bool FractureWorld::Impl::anyWasHeld(const std::vector<Break>& breaks) const {
    return std::any_of(breaks.begin(), breaks.end(), [&](const Break& broken) {
        const auto& whole = log_.ofStep()[broken.event].broken;
        return whole && whole->asset.solid()->isAnchored();
    });
}

/// Whether more than the gate has decided a blow on the body in this step.
bool FractureWorld::Impl::wasDecided(const Breakable& breakable) const {
    return std::any_of(log_.ofStep().begin(), log_.ofStep().end(), [&](const QueuedEvent& queued) {
        return queued.event.body == breakable.body && queued.event.level != Level::gate;
    });
}

std::vector<StruckBreakable> FractureWorld::Impl::struck(const btContactSolverInfo& info) {
    const AddedTime time(times_.steps.contacts);
    ContactCollector collector(breakables_, before_, time_s_, info, &birth_overlaps_, &recent_strikes_);
    feedSolvedContacts(world_, collector);
    auto struck = collector.takeStruck();
    recent_strikes_.note(struck, time_s_, info.m_timeStep);
    return struck;
}

void FractureWorld::Impl::bodiesEnter(const std::vector<btCollisionObject*>& bodies) {
    if (any_breakable_) before_.add(bodies);
}

bool FractureWorld::Impl::isBreakable(const btCollisionObject& object) const {
    return breakables_.of(object) != nullptr;
}

bool FractureWorld::Impl::isFragment(const btCollisionObject& object) const {
    return breakables_.isFragment(object);
}

std::vector<const Breakable*> FractureWorld::Impl::bodiesInWorld() const {
    std::vector<const Breakable*> bodies;
    for (const auto& breakable : breakables_.all())
        if (breakable->in_world) bodies.push_back(breakable.get());
    return bodies;
}

SteadiedBodies FractureWorld::Impl::steadiedBodies() const {
    return {breakables_, birth_overlaps_, [this](const auto& object) { return isFragmentOfAny(object); },
            moved_ground_.surfaces()};
}

bool FractureWorld::Impl::isFragmentOfAny(const btCollisionObject& object) const {
    bool found = false;
    decorator_.forEachListener([&](const StepListener& hook) { found = found || hook.isFragment(object); });
    return found;
}

}  // namespace sherd
