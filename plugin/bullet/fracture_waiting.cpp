// Blows that wait for their turn, as the budget has it.

#include <algorithm>
#include <limits>
#include <utility>

#include "bullet/contact_motion.h"
#include "bullet/conversions.h"
#include "bullet/fracture_world_impl.h"
#include "bullet/world_internals.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {

namespace {

constexpr const char* too_long_a_queue =
    "it would have waited for longer than Budget::longest_wait_s; raise that, or milliseconds_per_step and "
    "solves_per_step";

/// The larger, the sooner.
double urgency(const StruckBreakable& struck, const Budget& budget) {
    switch (budget.priority) {
        case Priority::nearest:
            return -(struck.position - budget.viewpoint).norm();
        case Priority::largest:
            return struck.breakable->asset.mass();
        case Priority::hardest:
            break;
    }
    return normalImpulse(struck.blow);
}

}  // namespace

Status FractureWorld::Impl::setBudget(const Budget& budget) {
    if (const Status valid = budget.validate(); !valid) return valid;
    budget_ = budget;
    return success();
}

/// How many more fragments may be in the world.
int FractureWorld::Impl::roomForFragments() const {
    const auto alive =
        std::count_if(breakables_.all().begin(), breakables_.all().end(),
                      [](const auto& breakable) { return breakable->isFragment() && breakable->in_world; });
    return budget_.fragments_alive - static_cast<int>(alive);
}

/// Tells of the blows on bodies that have no room for as few fragments as they may break into, and leaves
/// them out: they are not solved.
void FractureWorld::Impl::dropWithoutRoom(const std::vector<StruckBreakable>& struck, Gated& gated,
                                          int room) {
    const auto has_room = [&](std::size_t i) {
        return room + struck[i].breakable->ownPlaces() >= fewest_fragments;
    };
    const auto without = std::stable_partition(gated.now.begin(), gated.now.end(), has_room);
    for (auto i = without; i != gated.now.end(); ++i) {
        times_.blows += gated.ms[*i];
        tellTooMany(struck[*i], normalImpulse(struck[*i].blow));
    }
    gated.now.erase(without, gated.now.end());
}

/// Takes the places of a broken body's fragments. False, and told, if there are too few: the body stays
/// whole.
bool FractureWorld::Impl::takeRoom(const StruckBreakable& struck, const BlowOutcome& outcome, int& room) {
    if (outcome.outcome != Outcome::broke) return true;
    const int more = static_cast<int>(outcome.fragments.size()) - struck.breakable->ownPlaces();
    if (more > room) {
        tellTooMany(struck, outcome.impulse_n_s);
        return false;
    }
    room -= more;
    return true;
}

/// Whether the blow may be decided later: one on a fragment, unless a body that strikes it would be turned
/// back by what is broken in truth.
bool FractureWorld::Impl::mayWait(const StruckBreakable& struck) const {
    const Breakable& breakable = *struck.breakable;
    if (budget_.shortest_wait_s == 0 || !breakable.isFragment()) return false;
    const double mass =
        breakable.isDynamic() ? 1 / breakable.body->getInvMass() : std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < struck.partners.size(); ++p) {
        const btRigidBody* partner = btRigidBody::upcast(struck.partners[p]);
        if (!partner || partner->getInvMass() == 0 || isFragmentOfAny(*partner)) continue;
        if (struck.blow.isStruckBy(static_cast<int>(p)) && 1 / partner->getInvMass() < mass) return false;
    }
    return true;
}

/// Whether the blow on a whole body may be decided later: nothing flies through the body, it is struck by
/// other breakable bodies, by what does not move, or by what it cannot slow down.
bool FractureWorld::Impl::lastsWhileItWaits(const StruckBreakable& struck) const {
    constexpr btScalar much_heavier = 50;  // whole or broken, the body takes a few percent of its speed
    for (std::size_t p = 0; p < struck.partners.size(); ++p) {
        if (struck.partners[p]->isStaticObject() || breakables_.of(*struck.partners[p])) continue;
        const btRigidBody* partner = btRigidBody::upcast(struck.partners[p]);
        const bool is_slowed =
            !partner || much_heavier * partner->getInvMass() > struck.breakable->body->getInvMass();
        if (is_slowed && struck.blow.isStruckBy(static_cast<int>(p))) return false;
    }
    return true;
}

/// Whether the body is set down, or pressed: how fast it rebounds until it breaks is not seen.
bool FractureWorld::Impl::isStruckSlowly(const StruckBreakable& struck) const {
    constexpr double slow_m_s = 0.5;  // a fall of 1.3 cm
    if (struck.blow.isSqueezed()) return struck.blow.stack.strike.speed_m_s < slow_m_s;
    const auto is_slow = [&](const ContactImpulse& contact) { return contact.approach_m_s < slow_m_s; };
    return std::all_of(struck.blow.contacts.begin(), struck.blow.contacts.end(), is_slow);
}

/// Whether fragments strike the body, and nothing else does.
bool FractureWorld::Impl::isStruckByFragmentsAlone(const StruckBreakable& struck) const {
    bool is_struck = false;
    for (std::size_t p = 0; p < struck.partners.size(); ++p) {
        if (!struck.blow.isStruckBy(static_cast<int>(p))) continue;
        if (!isFragmentOfAny(*struck.partners[p])) return false;
        is_struck = true;
    }
    return is_struck;
}

/// Lets blows on whole bodies wait, the least urgent first, until the others take no longer than the budget
/// has milliseconds: those that nothing flies through, where there is more to be decided in the step, where
/// an earlier one waits, or where fragments strike, or anything slowly. One that fragments strike is decided
/// in any case if the step has no more.
void FractureWorld::Impl::thinOut(const std::vector<StruckBreakable>& struck, double time_step_s,
                                  Gated& gated) const {
    if (budget_.shortest_wait_s == 0) return;
    const auto begin = gated.now.begin(), end = gated.now.end();
    const auto lasts = [&](std::size_t i) { return lastsWhileItWaits(struck[i]); };
    const bool are_many = decided_now_ + (end - begin) > budget_.solves_per_step;
    const bool is_crowd = are_many || decided_now_ > 0 || !std::all_of(begin, end, lasts);
    const auto waits_alone = [&](std::size_t i) {
        return isStruckSlowly(struck[i]) || waiting_.hasOneOn(struck[i].breakable->serial);
    };
    const auto must_not_wait = [&](std::size_t i) {
        if (!lasts(i)) return true;
        if (waits_alone(i) || isStruckByFragmentsAlone(struck[i])) return false;
        // What stands under or behind the body that is struck breaks with it.
        return struck[i].blow.isSqueezed() ? !are_many : !is_crowd;
    };
    const auto may_wait = std::stable_partition(begin, end, must_not_wait);
    const auto all_may_wait =
        std::stable_partition(may_wait, end, [&](std::size_t i) { return !is_crowd && !waits_alone(i); });
    const auto is_more_urgent = [&](std::size_t a, std::size_t b) {
        return urgency(struck[a], budget_) > urgency(struck[b], budget_);
    };
    std::stable_sort(may_wait, all_may_wait, is_more_urgent);
    std::stable_sort(all_may_wait, end, is_more_urgent);
    const double most_ms = millisecondsPerStep(budget_, time_step_s);
    double ms = decided_now_ms_;
    int count = decided_now_;
    auto first = begin;
    for (; first != end; ++first, ++count) {
        ms += estimatedMilliseconds(*struck[*first].breakable->asset.solid());
        const bool has_no_room = ms > most_ms || count >= budget_.solves_per_step;
        if (first >= may_wait && has_no_room && (count > 0 || first >= all_may_wait)) break;
    }
    gated.later.insert(gated.later.end(), first, end);
    gated.now.erase(first, end);
    std::sort(gated.now.begin(), gated.now.end());
    std::sort(gated.later.begin(), gated.later.end());
}

void FractureWorld::Impl::letWait(std::vector<const StruckBreakable*> blows, btScalar time_step_s) {
    std::stable_sort(blows.begin(), blows.end(), [&](const StruckBreakable* a, const StruckBreakable* b) {
        return urgency(*a, budget_) > urgency(*b, budget_);
    });
    const int room = roomForFragments();
    for (const StruckBreakable* struck : blows) {
        const Breakable& breakable = *struck->breakable;
        const int most_fragments = std::min(room + breakable.ownPlaces(), budget_.fragments_per_step);
        if (most_fragments < fewest_fragments) {
            tellTooMany(*struck, normalImpulse(struck->blow));
            continue;
        }
        const btTransform from_world = breakable.placed(struck->before.transform).inverse();
        WaitingBlow blow;
        blow.serial = breakable.serial;
        blow.impulse_n_s = normalImpulse(struck->blow);
        blow.position = fromBullet(from_world * toBullet(struck->position));
        blow.normal = fromBullet(from_world.getBasis() * toBullet(struck->normal));
        if (struck->striker) {
            blow.striker = struck->striker;
            blow.striker_token = giveToken(*const_cast<btCollisionObject*>(struck->striker));
        }
        blow.decided = DecidedBlow::make(toDecide(*struck, most_fragments));
        const double work_ms = estimatedMilliseconds(*breakable.asset.solid());
        switch (waiting_.add(std::move(blow), work_ms, budget_, time_s_, time_step_s)) {
            case WaitingBlows::Fate::waits:
                break;
            case WaitingBlows::Fate::merged:
                ++counts_.merged;
                break;
            case WaitingBlows::Fate::dropped:
                tellDropped(*struck, normalImpulse(struck->blow), too_long_a_queue);
                break;
        }
    }
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
    if (executor_ && !*executor_) {
        const OnThisThreadAlone no_threads;
        waiting_.workUntil(time_s_);
    } else if (!waiting_.empty()) {
        waiting_.submit(executor(), time_s_);
    }
    while (const WaitingBlow* due = waiting_.due(time_s_)) {
        due->decided->finish(times_.steps.waiting);
        const auto& all = breakables_.all();
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& breakable) {
            return breakable->serial == due->serial && isInWorld(world_, breakable->body);
        });
        const int count = static_cast<int>(due->decided->outcome.fragments.size());
        if (new_fragments_ > 0 && count > budget_.fragments_per_step - new_fragments_)
            return;  // the next step has room
        const WaitingBlow blow = waiting_.takeFirst();
        if (found == all.end() || isToBeRemoved(**found) || !(*found)->canBeStruck()) {
            ++counts_.merged;
            continue;
        }
        const double waited_s = time_s_ - blow.struck_at_s;
        if (count > 0 && count > roomForFragments() + (*found)->ownPlaces()) {
            (blow.decided->doneElsewhere() ? times_.workers : times_.blows) += blow.decided->outcome.ms;
            tellTooMany(struckNow(**found, blow), blow.impulse_n_s, waited_s);
            continue;
        }
        BlowOutcome& outcome = blow.decided->outcome;
        outcome.waited_s = waited_s;
        ++counts_.waited;
        const auto broken = tell(struckNow(**found, blow), outcome, blow.decided);
        if (!broken) continue;
        Break due_break = *broken;
        const auto fragments = swap(due_break, time_step_s);
        if (!fragments.empty()) findNewContacts(fragments);
    }
}

}  // namespace sherd
