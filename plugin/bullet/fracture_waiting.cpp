// Blows that wait for their turn, as the budget has it.

#include <algorithm>
#include <limits>
#include <utility>

#include "bullet/fracture_world_impl.h"
#include "bullet/island/contact_motion.h"
#include "bullet/strikes/applied_blow.h"
#include "bullet/world/conversions.h"
#include "bullet/world/world_internals.h"
#include "fracture/blow_stress.h"

namespace sherd {

namespace {

constexpr const char* too_long_a_queue =
    "it would have waited for longer than Budget::longest_wait_s; raise that, or milliseconds_per_step and "
    "solves_per_step";

}  // namespace

Status FractureWorld::Impl::setBudget(const Budget& budget) {
    if (const Status valid = budget.validate(); !valid) return valid;
    budget_ = budget;
    waiting_.keepTo(budget, time_s_);
    return success();
}

/// How many more fragments may have their stress problem made before it is needed.
int FractureWorld::Impl::roomForPrepared() const {
    const auto prepared = std::count_if(
        breakables_.all().begin(), breakables_.all().end(),
        [](const auto& body) { return body->isFragment() && body->asset.solid()->expectsFactor(); });
    return std::max(0, budget_.prepared_fragments - static_cast<int>(prepared));
}

/// How many more fragments may be in the world.
int FractureWorld::Impl::roomForFragments() const {
    const auto alive =
        std::count_if(breakables_.all().begin(), breakables_.all().end(),
                      [](const auto& breakable) { return breakable->isFragment() && breakable->in_world; });
    constexpr int most = std::numeric_limits<int>::max() / 2;  // a body's own places are added to it
    return std::min(budget_.fragments_alive, most) - static_cast<int>(alive);
}

/// Tells of the blows on bodies that have no room for as few fragments as they may break into, and leaves
/// them out: they are not solved.
void FractureWorld::Impl::dropWithoutRoom(const std::vector<StruckBreakable>& struck, GatedBlows& gated,
                                          int room) {
    const auto has_room = [&](std::size_t i) {
        return room + struck[i].breakable->ownPlaces() >= fewest_fragments;
    };
    const auto without = std::stable_partition(gated.now.begin(), gated.now.end(), has_room);
    for (auto i = without; i != gated.now.end(); ++i) {
        times_.blows += gated.ms[*i];
        log_.addTooMany(struck[*i], normalImpulse(struck[*i].blow));
    }
    gated.now.erase(without, gated.now.end());
}

/// Takes the places of a broken body's fragments. False, and told, if there are too few: the body stays
/// whole.
bool FractureWorld::Impl::takeRoom(const StruckBreakable& struck, const BlowOutcome& outcome, int& room) {
    if (outcome.outcome != Outcome::broke) return true;
    const int more = static_cast<int>(outcome.fragments.size()) - struck.breakable->ownPlaces();
    if (more > room) {
        log_.addTooMany(struck, outcome.impulse_n_s);
        return false;
    }
    room -= more;
    return true;
}

/// Whether the body waits to break by a harder blow that may not be dropped, and nothing flies through it
/// until then.
bool FractureWorld::Impl::isOutdone(const StruckBreakable& struck) const {
    const WaitingBlow* waiting = waiting_.keptFor(struck.breakable->serial);
    return waiting && waiting->energy_j >= energyOf(struck) &&
           patience_.lastsWhileItWaits(struck, much_heavier);
}

double FractureWorld::Impl::energyOf(const StruckBreakable& struck) const {
    const BreakableSolid& solid = *struck.breakable->asset.solid();
    return blowEnergy(struck.blow, solid.mass(), isHeld(solid, struck.blow));
}

/// What the time that the queue has left is short of the work that may not be dropped: so many times faster
/// than the budget says it is done.
double FractureWorld::Impl::hasteFor(const std::vector<const StruckBreakable*>& blows,
                                     btScalar time_step_s) const {
    double needed_s = 0;
    for (const StruckBreakable* struck : blows)
        if (struck->isKept())
            needed_s += WaitingBlows::turn_s(
                estimatedMilliseconds(*struck->breakable->asset.solid(), struck->blow), budget_, time_step_s);
    return needed_s > 0 ? std::max(1.0, needed_s / waiting_.left_s(budget_, time_s_)) : 1;
}

/// `promised`: places of fragments that are not in the world yet.
void FractureWorld::Impl::letWait(std::vector<const StruckBreakable*> blows, int promised,
                                  btScalar time_step_s) {
    std::stable_sort(blows.begin(), blows.end(), [&](const StruckBreakable* a, const StruckBreakable* b) {
        return patience_.isMoreUrgent(*a, *b);
    });
    const auto kept =
        std::count_if(blows.begin(), blows.end(), [](const auto* blow) { return blow->isKept(); });
    const int room = std::max(0, roomForFragments() - waiting_.promised() - promised);
    const int share = std::min(room, std::max(fewest_fragments, room / std::max(1, static_cast<int>(kept))));
    const double haste = hasteFor(blows, time_step_s);
    for (const StruckBreakable* struck : blows) {
        const Breakable& breakable = *struck->breakable;
        const int places = (struck->isKept() ? share : room) + breakable.ownPlaces();
        const int most_fragments = std::min(places, budget_.fragments_per_step);
        if (most_fragments < fewest_fragments) {
            log_.addTooMany(*struck, normalImpulse(struck->blow));
            continue;
        }
        const btTransform from_world = breakable.placed(struck->before.transform).inverse();
        WaitingBlow blow;
        blow.serial = breakable.serial;
        blow.is_on_fragment = breakable.isFragment();
        blow.impulse_n_s = normalImpulse(struck->blow);
        blow.work_ms = estimatedMilliseconds(*breakable.asset.solid(), struck->blow);
        blow.energy_j = energyOf(*struck);
        blow.position = fromBullet(from_world * toBullet(struck->position));
        blow.normal = fromBullet(from_world.getBasis() * toBullet(struck->normal));
        if (struck->striker) {
            blow.striker = struck->striker;
            blow.striker_token = giveToken(*const_cast<btCollisionObject*>(struck->striker));
        }
        BlowToDecide question = toDecide(*struck, most_fragments);
        if (auto foreseen = takeForeseen(*struck, question)) {
            blow.solved_by_s = foreseen->solved_by_s;
            blow.decided = std::move(foreseen->decided);
        } else {
            blow.decided = DecidedBlow::make(std::move(question));
        }
        blow.is_kept = struck->isKept();
        blow.promised =
            std::min(most_fragments, breakable.fracture->largest_fragment_count) - breakable.ownPlaces();
        blow.for_pieces = moved(struck->for_pieces, from_world);
        const double turn_s =
            WaitingBlows::turn_s(blow.work_ms, budget_, time_step_s) / (blow.is_kept ? haste : 1);
        switch (waiting_.add(std::move(blow), turn_s, budget_, time_s_)) {
            case WaitingBlows::Fate::waits:
                break;
            case WaitingBlows::Fate::merged:
                ++counts_.merged;
                break;
            case WaitingBlows::Fate::dropped:
                log_.addDropped(*struck, normalImpulse(struck->blow), too_long_a_queue);
                break;
        }
    }
}

/// What a step decides has all cores.
void FractureWorld::Impl::interruptWaiting(btScalar time_step_s) {
    const double until_now_s = std::min<double>(time_step_s, 1e-3 * spent_.decided_ms);
    waiting_.interrupt(until_now_s - spent_.interrupted_s, budget_, time_s_);
    spent_.interrupted_s = until_now_s;
}

/// The blow on a body that has moved on meanwhile.
StruckBreakable FractureWorld::Impl::struckNow(Breakable& breakable, const WaitingBlow& blow) const {
    StruckBreakable struck;
    struck.breakable = &breakable;
    struck.before = stateOf(*breakable.body);
    const btTransform placed = breakable.placed(struck.before.transform);
    struck.position = fromBullet(placed * toBullet(blow.position));
    struck.normal = fromBullet(placed.getBasis() * toBullet(blow.normal));
    // The app may have deleted it, and made another object at its address.
    const bool is_there = isInWorld(world_, blow.striker) && tokenOf(*blow.striker) == blow.striker_token;
    if (is_there) struck.striker = blow.striker;
    return struck;
}

/// The blows whose turn it is: their bodies break where they are by now.
void FractureWorld::Impl::answerWaiting(btScalar time_step_s) {
    const ThreadsAsAllowed threads(*this);
    if (!mayHaveThreads())
        waiting_.workUntil(time_s_);
    else if (!waiting_.empty())
        waiting_.submit(executor(), time_s_);
    while (const WaitingBlow* due = waiting_.due(time_s_)) {
        waiting_.finishFirst(time_s_ + time_step_s, times_.steps.waiting);
        const auto& all = breakables_.all();
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& breakable) {
            return breakable->serial == due->serial && isInWorld(world_, breakable->body);
        });
        const int count = static_cast<int>(due->decided->outcome.fragments.size());
        if (spent_.new_fragments > 0 && count > budget_.fragments_per_step - spent_.new_fragments)
            return;  // the next step has room
        const WaitingBlow blow = waiting_.takeFirst();
        if (found == all.end() || isToBeRemoved(**found) || !(*found)->canBeStruck()) {
            ++counts_.merged;
            continue;
        }
        const double waited_s = time_s_ - blow.struck_at_s;
        if (count > 0 && count > roomForFragments() + (*found)->ownPlaces()) {
            (blow.decided->doneElsewhere() ? times_.workers : times_.blows) += blow.decided->outcome.ms;
            kept_factors_.noteDecided(**found, breakables_);
            log_.addTooMany(struckNow(**found, blow), blow.impulse_n_s, waited_s);
            continue;
        }
        BlowOutcome& outcome = blow.decided->outcome;
        outcome.waited_s = waited_s;
        ++counts_.waited;
        const auto broken = tell(struckNow(**found, blow), outcome, blow.decided);
        if (!broken) continue;
        Break due_break = *broken;
        due_break.for_pieces = moved(blow.for_pieces, (*found)->placed((*found)->body->getWorldTransform()));
        const auto fragments = swap(due_break, time_step_s);
        if (fragments.empty()) continue;
        before_.add(fragments);  // for `stopAtGround`: they are still to move in this step
        findNewContacts(fragments);
    }
}

}  // namespace sherd
