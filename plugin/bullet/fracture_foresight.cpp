// Which blows are about to fall, so that they are solved beside the steps before.

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "bullet/fracture_world_impl.h"
#include "bullet/schedule/rehearsal.h"
#include "bullet/strikes/torn_out.h"
#include "fracture/decide_blow.h"

namespace sherd {

/// At the end of a step: rehearses the ways of bodies that may break something soon.
void FractureWorld::Impl::lookAhead() {
    if (budget_.foresight_s == 0 || !awake_ || !decorator_.inPlace() || !Rehearsal::mayRehearse(world_)) {
        counts_.foreseen_in_vain += foresight_.clear();
        return;
    }
    const AddedTime time(times_.steps.foresight);
    counts_.foreseen_in_vain += foresight_.follow(world_, time_s_);
    const std::vector<btRigidBody*> movers = fastBodies(world_);
    if (movers.empty() || roomForFragments() < fewest_fragments) return;
    double least_energy_j = std::numeric_limits<double>::infinity();
    bool some_unanswered = false;
    for (const auto& breakable : breakables_.all())
        if (isForeseeable(*breakable, time_s_)) {
            least_energy_j = std::min(least_energy_j, breakable->least_energy_j);
            some_unanswered = some_unanswered || !breakable->asset.solid()->hasSolver();
        }
    const ThreadsAsAllowed threads(*this);
    std::optional<Touching> touching;
    for (btRigidBody* body : movers) {
        if (foresight_.credit() <= 0) return;
        if (!mayBring(*body, least_energy_j) || isFragmentOfAny(*body)) continue;
        if (some_unanswered) makeSolversFor(*body);
        const BodyToken token = giveToken(*body);
        if (token == no_token || !foresight_.isToBeLookedAt(token, time_s_, budget_.foresight_s)) continue;
        if (!touching) touching.emplace(world_);
        const std::vector<Role> roles =
            rolesAround(world_, *touching, breakables_, before_, *body, 2 * budget_.foresight_s, time_s_);
        if (!roles.empty()) rehearse(*body, token, roles);
    }
}

/// Stress problems take longer to be made than blows are foreseen ahead.
void FractureWorld::Impl::makeSolversFor(const btRigidBody& mover) {
    constexpr double ahead_s = 1;
    for (const Breakable* body : breakablesAround(world_, breakables_, mover, ahead_s, time_s_))
        solvers_ahead_.addStruckSoon(*body, time_s_, mayHaveThreads());
}

/// The blow that falls as it was foreseen; none for others.
std::optional<ForeseenBlow> FractureWorld::Impl::takeForeseen(const StruckBreakable& struck,
                                                              const BlowToDecide& blow) {
    auto foreseen = foresight_.take(struck, blow, time_s_);
    if (!foreseen) return std::nullopt;
    ++counts_.foreseen;
    foreseen->decided->is_foreseen = true;
    return foreseen;
}

/// Until something whole is struck such that it may break, or for as long as there is credit.
void FractureWorld::Impl::rehearse(const btRigidBody& mover, BodyToken token,
                                   const std::vector<Role>& roles) {
    constexpr std::size_t most_steps = 100;
    Rehearsal rehearsal(world_, birth_overlaps_, recent_strikes_, roles, time_s_);
    std::vector<BodyState> way;
    std::vector<ForeseenBlow> found;
    const double until_s = time_s_ + 2 * budget_.foresight_s;
    const double time_step_s = world_.getSolverInfo().m_timeStep;
    constexpr int gate_cost = 20;  // of a blow
    constexpr int least = 300;     // of what is worth beginning; the next steps have less for that
    const int most_cost = std::max(least, foresight_.credit());
    int cost = 0;
    while (found.empty() && rehearsal.time() < until_s && way.size() < most_steps && cost < most_cost) {
        std::vector<StruckBreakable> struck = rehearsal.step();
        cost += rehearsal.costOfStep() + gate_cost * static_cast<int>(struck.size());
        found = worthSolving(std::move(struck), rehearsal.time());
        way.push_back(rehearsal.stateOf(mover));
    }
    const bool is_too_dear = found.empty() && way.size() == 1 && cost >= most_cost;
    foresight_.note(token, std::move(way), rehearsal.time(), cost, is_too_dear);
    for (ForeseenBlow& blow : found) {
        blow.mover = token;
        blow.decided = DecidedBlow::make(blow.blow);
        if (mayHaveThreads()) blow.decided->submit(executor());
        const double work_ms = estimatedMilliseconds(*blow.blow.solid, blow.blow.blow);
        foresight_.note(std::move(blow), WaitingBlows::turn_s(work_ms, budget_, time_step_s));
    }
}

/// Of the blows that fall together in a rehearsal those that may break a body of which no other one is
/// foreseen. Most of a crowd wait when they have fallen: of these no more are solved before than there is
/// time for, the most urgent ones.
std::vector<ForeseenBlow> FractureWorld::Impl::worthSolving(std::vector<StruckBreakable> struck,
                                                            double strikes_at_s) const {
    const double time_step_s = world_.getSolverInfo().m_timeStep;
    struck.erase(std::remove_if(struck.begin(), struck.end(),
                                [&](const auto& blow) { return !mayBreakSoon(blow, strikes_at_s); }),
                 struck.end());
    const bool are_many = static_cast<int>(struck.size()) > budget_.solves_per_step;
    if (are_many)
        std::stable_sort(struck.begin(), struck.end(),
                         [&](const auto& a, const auto& b) { return patience_.isMoreUrgent(a, b); });
    double ms = (strikes_at_s - time_s_) / time_step_s * millisecondsPerStep(budget_, time_step_s);
    int full_solves = foresight_.fullSolves();
    std::vector<ForeseenBlow> found;
    for (const StruckBreakable& blow : struck) {
        const bool must_not_wait = !patience_.lastsWhileItWaits(blow, much_heavier);
        if (are_many && !must_not_wait && !(ms > 0)) continue;
        ms -= estimatedMilliseconds(*blow.breakable->asset.solid(), blow.blow);
        // Each full solve leaves its factor behind.
        const bool is_solved_in_full = !blow.breakable->asset.solid()->reducedStress();
        if (is_solved_in_full && full_solves++ >= budget_.solves_per_step) continue;
        found.push_back(asForeseen(blow, strikes_at_s));
    }
    return found;
}

bool FractureWorld::Impl::mayBreakSoon(const StruckBreakable& struck, double strikes_at_s) const {
    const Breakable& body = *struck.breakable;
    double gate_ms = 0;  // part of looking ahead
    return isForeseeable(body, strikes_at_s) && !patience_.mayWait(struck) && !isLightRest(struck, time_s_) &&
           !foresight_.isForeseen(body.serial) &&
           !heldByGate(*body.asset.solid(), struck.blow, *body.fracture, seedOf(body), gate_ms, body.damaged);
}

ForeseenBlow FractureWorld::Impl::asForeseen(const StruckBreakable& struck, double strikes_at_s) const {
    const Breakable& body = *struck.breakable;
    ForeseenBlow blow;
    blow.is_solved_in_full = !body.asset.solid()->reducedStress();
    blow.serial = body.serial;
    blow.found_at_s = time_s_;
    blow.strikes_at_s = strikes_at_s;
    for (const btCollisionObject* partner : struck.partners)
        blow.partners.push_back(giveToken(*const_cast<btCollisionObject*>(partner)));
    blow.blow = toDecide(struck, placesAhead(body, roomForFragments()));
    return blow;
}

/// Fragments at most of a body whose blow is solved before it falls, when nobody knows what else breaks then.
int FractureWorld::Impl::placesAhead(const Breakable& body, int room) const {
    return std::min(room + body.ownPlaces(), budget_.fragments_per_step);
}

/// The pieces that come of each blow of `gated.now` that falls as it was foreseen, early enough for the
/// budget's time to have solved it by now: the step only swaps the body. None if there is no room for all of
/// them: then they are solved anew for fewer, as others are.
void FractureWorld::Impl::findSolvedAhead(const std::vector<StruckBreakable>& struck, GatedBlows& gated) {
    const int room = gated.now.empty() ? 0 : roomForFragments();
    int room_left = room, places_left = budget_.fragments_per_step - spent_.new_fragments;
    for (const std::size_t i : gated.now) {
        const Breakable& body = *struck[i].breakable;
        if (foresight_.isForeseen(body.serial)) {
            const BlowToDecide blow = toDecide(struck[i], placesAhead(body, room));
            const ForeseenBlow* foreseen = foresight_.find(struck[i], blow);
            if (foreseen && foreseen->isSolvedInTime()) {
                foreseen->decided->finish(times_.steps.waiting);
                gated.ahead[i] = static_cast<int>(foreseen->decided->outcome.fragments.size());
            }
        }
        const int pieces = gated.ahead[i].value_or(fewest_fragments);
        if (pieces > 0) room_left -= pieces - body.ownPlaces();
        places_left -= pieces;
    }
    if (room_left < 0 || (places_left < 0 && budget_.shortest_wait_s == 0))
        std::fill(gated.ahead.begin(), gated.ahead.end(), std::nullopt);
}

}  // namespace sherd
