// What a FractureWorld does in a step of Bullet's.

#include <algorithm>
#include <utility>

#include "bullet/conversions.h"
#include "bullet/fracture_world_impl.h"
#include "bullet/ground_contact.h"
#include "bullet/steady_contacts.h"
#include "core/numerics/split_mix.h"
#include "fracture/decide_blow.h"

namespace sherd {

namespace {

constexpr int most_rounds = 8;  // of breaks in one step

/// What the asset warns of, with the first blow on its body.
std::vector<std::string> warningsAtFirstBlow(Breakable& breakable) {
    if (std::exchange(breakable.warned, true)) return {};
    return breakable.asset.warnings();
}

BlowEvent eventOf(const StruckBreakable& struck, const BlowFigures& figures) {
    BlowEvent event(struck.breakable->asset);
    static_cast<BlowFigures&>(event) = figures;
    event.name = struck.breakable->name;
    event.asset_transform = struck.breakable->placed(struck.before.transform);
    event.velocity = fromBullet(struck.before.linear);
    event.angular_velocity = fromBullet(struck.before.angular);
    event.body = struck.breakable->body;
    event.position = struck.position;
    event.normal = struck.normal;
    return event;
}

}  // namespace

// `times_.whole` is measured here, and in `finishBetweenSteps`: these are all the ways in from outside.

void FractureWorld::Impl::beforeSolve() {
    timed(times_.whole, [&] { prepareSolve(); });
    solve_watch_ = {};
}

void FractureWorld::Impl::afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) {
    times_.bullet_solve += solve_watch_.milliseconds();
    time_s_ += info.m_timeStep;
    if (!any_breakable_) return;
    const AddedTime whole(times_.whole);
    solveBreaks(info, drawer);
    timed(times_.steps.snapshot, [&] { write_back_.end(world_); });
    any_breakable_ = false;
}

void FractureWorld::Impl::endSolve(const btContactSolverInfo& info) {
    timed(times_.whole, [&] {
        finish(info.m_timeStep);
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
    timed(times_.whole, [&] {
        timed(times_.steps.ground, [&] { stopAtGround(world_, breakables_, before_); });
        endIntegration();
    });
    markBetweenSteps(world_);
    deleteIfReleased();
}

void FractureWorld::Impl::endIntegration() {
    integrating_ = false;
    timed(times_.steps.sweep, [&] { sweep_exceptions_.end(); });
    finish(0);
}

void FractureWorld::Impl::prepareSolve() {
    StepTimes& ms = times_.steps;
    timed(ms.release, [&] {
        to_delete_.clear();
        events_.deleteReleased();
    });
    if (integrating_) {  // the world went on without calling its actions
        world_calls_actions_ = false;
        endIntegration();
    }
    timed(ms.sync, [&] {
        breakables_.dropReplaced(world_.getCollisionObjectArray());
        breakables_.syncWithWorld(world_.getCollisionObjectArray());
        const auto& all = breakables_.all();
        any_breakable_ =
            std::any_of(all.begin(), all.end(), [](const auto& breakable) { return breakable->in_world; });
    });
    if (!any_breakable_) return;
    timed(ms.overlaps, [&] {
        birth_overlaps_.applyAllowances(world_);
        steadyContacts(world_, breakables_);
    });
    timed(ms.ground, [&] { addGroundContacts(world_, fragments()); });
    timed(ms.snapshot, [&] {
        before_.take(world_);
        write_back_.begin(world_);
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
    breaks = evaluateBlows(struck(info));
    for (int round = 1; !breaks.empty(); ++round) {
        const auto is_broken = [&](const auto& object) {
            return std::any_of(breaks.begin(), breaks.end(),
                               [&](const Break& broken) { return broken.body == &object; });
        };
        const auto through = timed(times_.steps.sweep, [&] { return sweptInto(world_, is_broken); });
        const auto next = resolveIslands(breaks, through, round == most_rounds, info, drawer);
        std::vector<StruckBreakable> blows;
        if (!next.empty())
            for (StruckBreakable& blow : struck(info))
                if (std::find(next.begin(), next.end(), blow.breakable->body) != next.end())
                    blows.push_back(std::move(blow));
        breaks = evaluateBlows(blows);
    }
}

std::vector<StruckBreakable> FractureWorld::Impl::struck(const btContactSolverInfo& info) {
    const AddedTime time(times_.steps.contacts);
    ContactCollector collector(breakables_, before_, time_s_, info);
    feedSolvedContacts(world_, collector);
    return collector.takeStruck();
}

void FractureWorld::Impl::bodiesEnter(const std::vector<btCollisionObject*>& bodies) {
    if (any_breakable_) before_.add(bodies);
}

bool FractureWorld::Impl::isBreakable(const btCollisionObject& object) const {
    return breakables_.find(&object) != nullptr;
}

bool FractureWorld::Impl::isFragment(const btCollisionObject& object) const {
    const Breakable* breakable = breakables_.find(&object);
    return breakable && breakable->is_fragment;
}

std::vector<const Breakable*> FractureWorld::Impl::fragments() const {
    std::vector<const Breakable*> fragments;
    for (const auto& breakable : breakables_.all())
        if (breakable->is_fragment && breakable->in_world) fragments.push_back(breakable.get());
    return fragments;
}

bool FractureWorld::Impl::isFragmentOfAny(const btCollisionObject& object) const {
    bool found = false;
    decorator_.forEachListener([&](const StepListener& hook) { found = found || hook.isFragment(object); });
    return found;
}

std::vector<FractureWorld::Impl::Break> FractureWorld::Impl::evaluateBlows(
    const std::vector<StruckBreakable>& struck) {
    std::vector<Break> breaks;
    for (const StruckBreakable& body : struck) {
        if (isToBeRemoved(*body.breakable)) continue;
        const std::vector<std::string> warnings = warningsAtFirstBlow(*body.breakable);
        BlowOutcome outcome = decideBlow(*body.breakable->asset.solid(), body.blow, *body.breakable->fracture,
                                         seedOf(*body.breakable));
        ++counts_.seen;
        ++counts_.at(outcome.level);
        if (outcome.level == Level::gate && warnings.empty() && !outcome.full_solve_outcome) {
            times_.blows += outcome.ms;  // those of the others are added with their events
            continue;
        }
        outcome.warnings.insert(outcome.warnings.begin(), warnings.begin(), warnings.end());
        current_.push_back({eventOf(body, outcome), nullptr});
        if (outcome.outcome == Outcome::broke)
            breaks.push_back({body.breakable->body, std::move(outcome), current_.size() - 1});
    }
    return breaks;
}

std::uint64_t FractureWorld::Impl::seedOf(const Breakable& breakable) const {
    return breakable.seed ? *breakable.seed
                          : splitMix64(breakable.fracture->seed + golden_step * breakable.serial);
}

}  // namespace sherd
