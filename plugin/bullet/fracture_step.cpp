#include <algorithm>
#include <exception>

#include "bullet/body_swap.h"
#include "bullet/conversions.h"
#include "bullet/fracture_world_impl.h"
#include "core/numerics/split_mix.h"
#include "core/numerics/stopwatch.h"

namespace sherd {

namespace {

/// `strike` reports its failures in the outcome. This catches what it cannot report, such as running out of
/// memory: nothing may throw through Bullet's step.
BlowOutcome strikeWithoutThrowing(const BreakableSolid& solid, const Blow& blow, std::uint64_t seed) {
    BlowOutcome outcome;
    try {
        outcome = strike(solid, blow, seed);
    } catch (const std::exception& trouble) {
        outcome = BlowOutcome{};
        outcome.outcome = BreakEvent::Outcome::failed;
        outcome.message =
            std::string("the blow could not be worked out (") + trouble.what() + "); the body stays whole";
    }
    if (outcome.outcome == BreakEvent::Outcome::broke && outcome.fragments.empty())
        outcome.outcome = BreakEvent::Outcome::held;
    return outcome;
}

BreakEvent eventOf(const StruckBreakable& struck, const BlowOutcome& outcome) {
    BreakEvent event;
    event.outcome = outcome.outcome;
    event.broken = struck.breakable->body;
    event.position = struck.position;
    event.normal = struck.normal;
    event.impulse_n_s = outcome.impulse_n_s;
    event.peak_force_n = outcome.peak_force_n;
    event.contact_time_s = outcome.contact_time_s;
    event.largest_stress_pa = outcome.largest_stress_pa;
    event.mass_error_rel = outcome.mass_error_rel;
    event.volume_error_rel = outcome.volume_error_rel;
    event.residual_rel = outcome.residual_rel;
    event.ms = outcome.ms;
    event.message = outcome.message;
    return event;
}

std::vector<btCollisionObject*> without(std::vector<btCollisionObject*> objects,
                                        const btCollisionObject* left_out) {
    objects.erase(std::remove(objects.begin(), objects.end(), left_out), objects.end());
    return objects;
}

}  // namespace

void FractureWorld::Impl::beforeSolve() {
    to_delete_.clear();
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    const auto& all = breakables_.all();
    any_breakable_ =
        std::any_of(all.begin(), all.end(), [](const auto& breakable) { return breakable->in_world; });
    if (!any_breakable_) return;
    birth_overlaps_.applyAllowances(world_);
    before_.take(world_);
    write_back_.begin(world_);
}

void FractureWorld::Impl::afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) {
    time_s_ += info.m_timeStep;
    if (any_breakable_) {
        ContactCollector collector(breakables_, before_, time_s_, info);
        feedSolvedContacts(world_, collector);
        std::vector<Break> breaks = evaluateBlows(collector.takeStruck());
        if (!breaks.empty()) resolveIslands(breaks, info, drawer);
        write_back_.end(world_);
        any_breakable_ = false;
    }
    markStepDone();
    for (btRigidBody* body : std::exchange(to_remove_, {})) removeNow(body);
}

std::vector<FractureWorld::Impl::Break> FractureWorld::Impl::evaluateBlows(
    const std::vector<StruckBreakable>& struck) {
    std::vector<Break> breaks;
    for (const StruckBreakable& body : struck) {
        const BreakableSolid& solid = *body.breakable->asset.solid();
        ++counts_.seen;
        if (!canBreak(solid, body.blow)) {
            ++counts_.skipped;
            continue;
        }
        ++counts_.solved;
        BlowOutcome outcome = strikeWithoutThrowing(solid, body.blow, seedOf(*body.breakable));
        events_.push_back(eventOf(body, outcome));
        if (outcome.outcome == BreakEvent::Outcome::broke)
            breaks.push_back({body.breakable->body, std::move(outcome), events_.size() - 1});
    }
    return breaks;
}

void FractureWorld::Impl::resolveIslands(std::vector<Break>& breaks, const btContactSolverInfo& info,
                                         btIDebugDraw* drawer) {
    const Stopwatch watch;
    std::vector<btCollisionObject*> members;
    for (const Break& broken : breaks) members.push_back(broken.body);
    const Island whole = connectedIsland(world_, members);
    before_.restore(whole);
    members = whole.bodies;

    std::vector<btCollisionObject*> new_bodies;
    for (Break& broken : breaks) {
        const std::vector<btCollisionObject*> fragments = swap(broken, info.m_timeStep);
        if (!fragments.empty()) members = without(std::move(members), broken.body);
        new_bodies.insert(new_bodies.end(), fragments.begin(), fragments.end());
    }
    findContactsOf(world_, new_bodies);
    allowOverlapsAtBirth(new_bodies);
    members.insert(members.end(), new_bodies.begin(), new_bodies.end());

    // Fragments may touch bodies that the whole body did not, and their islands then have to be solved again
    // too.
    Island pieces = connectedIsland(world_, members);
    before_.restore(pieces);
    for (btCollisionObject* body : pieces.bodies) body->activate();
    solveIsland(world_, decorator_.inner(), pieces, info, drawer);
    for (const Break& broken : breaks)
        events_[broken.event].ms.resolve_step = watch.milliseconds() / breaks.size();
}

void FractureWorld::Impl::allowOverlapsAtBirth(const std::vector<btCollisionObject*>& new_bodies) {
    std::vector<btCollisionObject*> may_overlap;
    for (btCollisionObject* body : new_bodies)
        if (!breakables_.find(body)->owned.shape.disjoint) may_overlap.push_back(body);
    if (!may_overlap.empty()) birth_overlaps_.add(world_, may_overlap);
    birth_overlaps_.applyAllowances(world_);
}

std::vector<btCollisionObject*> FractureWorld::Impl::swap(Break& broken, btScalar time_step_s) {
    BreakEvent& event = events_[broken.event];
    const Breakable& parent = *breakables_.find(broken.body);
    std::vector<std::unique_ptr<Breakable>> pieces;
    try {
        const Stopwatch watch;
        pieces = makeFragmentBodies(parent, broken.outcome.fragments);
        event.ms.bodies += watch.milliseconds();
    } catch (const std::exception& trouble) {
        event.outcome = BreakEvent::Outcome::failed;
        event.message = std::string("the fragments' bodies could not be made (") + trouble.what() +
                        "); the body stays whole";
        return {};
    }
    event.momentum_error_rel = momentumError(*broken.body, pieces);
    event.dropped_mass_kg = dropDebris(broken.outcome.fragments, pieces);
    const btBroadphaseProxy& proxy = *broken.body->getBroadphaseHandle();
    const int group = proxy.m_collisionFilterGroup, mask = proxy.m_collisionFilterMask;
    event.removed_constraints = removeFromWorld(world_, *broken.body);
    addToWorld(world_, pieces, group, mask, time_step_s);

    const double unbreakable_until_s = time_s_ + parent.asset.solid()->settings().fracture.rest_after_break_s;
    std::vector<btCollisionObject*> objects;
    for (auto& piece : pieces) {
        piece->unbreakable_until_s = unbreakable_until_s;
        event.fragments.push_back(piece->body);
        objects.push_back(piece->body);
        registerBreakable(std::move(piece));
    }
    broken_.push_back(breakables_.take(broken.body));
    return objects;
}

std::uint64_t FractureWorld::Impl::seedOf(const Breakable& breakable) const {
    return splitMix64(breakable.asset.solid()->settings().fracture.seed + golden_step * breakable.serial);
}

}  // namespace sherd
