#include "bullet/schedule/patience.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "bullet/schedule/waiting_blows.h"
#include "bullet/strikes/torn_out.h"
#include "bullet/world/conversions.h"

namespace sherd {

namespace {

/// What strikes at a contact; nullptr where the app does, or nothing.
const btCollisionObject* strikerAt(const ContactImpulse& contact, const StruckBreakable& struck) {
    const bool is_of_app = contact.partner >= static_cast<int>(struck.partners.size());
    return contact.strikes() && !is_of_app ? struck.partners[contact.partner] : nullptr;
}

/// Those of its partners that strike it.
std::vector<const btCollisionObject*> strikersOf(const StruckBreakable& struck) {
    std::vector<const btCollisionObject*> strikers;
    for (std::size_t p = 0; p < struck.partners.size(); ++p)
        if (struck.blow.isStruckBy(static_cast<int>(p))) strikers.push_back(struck.partners[p]);
    return strikers;
}

}  // namespace

/// The larger, the sooner.
double Patience::urgency(const StruckBreakable& struck) const {
    switch (budget_.priority) {
        case Priority::nearest:
            return -(struck.position - budget_.viewpoint).norm();
        case Priority::largest:
            return struck.breakable->asset.mass();
        case Priority::hardest:
            break;
    }
    return normalImpulse(struck.blow);
}

bool Patience::mayWait(const StruckBreakable& struck) const {
    const Breakable& breakable = *struck.breakable;
    if (budget_.shortest_wait_s == 0 || !breakable.isFragment() || struck.isKept()) return false;
    const double mass =
        breakable.isDynamic() ? 1 / breakable.body->getInvMass() : std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < struck.partners.size(); ++p) {
        const btRigidBody* partner = btRigidBody::upcast(struck.partners[p]);
        if (!partner || partner->getInvMass() == 0 || is_fragment_(*partner)) continue;
        if (struck.blow.isStruckBy(static_cast<int>(p)) && 1 / partner->getInvMass() < mass) return false;
    }
    return true;
}

bool Patience::lastsWhileItWaits(const StruckBreakable& struck, btScalar times_as_heavy) const {
    for (std::size_t p = 0; p < struck.partners.size(); ++p) {
        if (struck.partners[p]->isStaticObject() || breakables_.of(*struck.partners[p])) continue;
        const btRigidBody* partner = btRigidBody::upcast(struck.partners[p]);
        const bool is_slowed =
            !partner || times_as_heavy * partner->getInvMass() > struck.breakable->body->getInvMass();
        if (is_slowed && struck.blow.isStruckBy(static_cast<int>(p))) return false;
    }
    return true;
}

/// Whether something that cannot break moves towards the body where it strikes it. A shelf or a lift at rest
/// does not: the body falls on it.
bool Patience::isMovedAgainst(const StruckBreakable& struck) const {
    constexpr double of_approach = 0.25;
    const btTransform from_asset = struck.breakable->placed(struck.before.transform);
    for (std::size_t i = 0; i < struck.blow.contacts.size(); ++i) {
        const ContactImpulse& contact = struck.blow.contacts[i];
        const btCollisionObject* striker = strikerAt(contact, struck);
        if (!striker || !btRigidBody::upcast(striker) || breakables_.of(*striker)) continue;
        const btVector3 own = struck.before.velocityAt(from_asset * toBullet(contact.point));
        const double brought = -own.dot(toBullet(struck.pushes[i]));
        if (contact.approach_m_s - brought > of_approach * contact.approach_m_s) return true;
    }
    return false;
}

/// Whether such a body runs into it, which is free and would not stop that: each that strikes it is many
/// times as heavy, as kinematic ones are.
bool Patience::isRunInto(const StruckBreakable& struck) const {
    constexpr btScalar times_as_heavy = 10;
    return struck.breakable->isDynamic() && lastsWhileItWaits(struck, times_as_heavy) &&
           isMovedAgainst(struck);
}

/// Whether it falls on what hardly gives way, and nothing flies through it.
bool Patience::fallsOnHeavy(const StruckBreakable& struck) const {
    constexpr btScalar times_as_heavy = 2;
    return struck.breakable->isDynamic() && lastsWhileItWaits(struck, times_as_heavy) &&
           !isMovedAgainst(struck);
}

/// Whether something that the body rests against pushes back at what runs into it: whole it would stop that.
bool Patience::isBacked(const StruckBreakable& struck) const {
    constexpr double back = -0.5;  // cosine
    const std::vector<ContactImpulse>& contacts = struck.blow.contacts;
    return std::any_of(contacts.begin(), contacts.end(), [&](const ContactImpulse& strike) {
        const btCollisionObject* striker = strikerAt(strike, struck);
        if (!striker || breakables_.of(*striker)) return false;
        return std::any_of(contacts.begin(), contacts.end(), [&](const ContactImpulse& contact) {
            return contact.supports() && contact.normal.dot(strike.normal) < back;
        });
    });
}

/// Whether fragments strike the body, and nothing else does.
bool Patience::isStruckByFragmentsAlone(const StruckBreakable& struck) const {
    const std::vector<const btCollisionObject*> strikers = strikersOf(struck);
    return !strikers.empty() &&
           std::all_of(strikers.begin(), strikers.end(),
                       [&](const btCollisionObject* striker) { return is_fragment_(*striker); });
}

/// Whether fragments strike it of which none has more than half of its mass: such a piece bounces off it,
/// and nobody sees that it breaks a few steps later.
bool Patience::isStruckByLightFragments(const StruckBreakable& struck) const {
    constexpr double light = 2;
    const Breakable& breakable = *struck.breakable;
    const double mass = breakable.isDynamic() ? 1 / breakable.body->getInvMass() : breakable.asset.mass();
    const std::vector<const btCollisionObject*> strikers = strikersOf(struck);
    return !strikers.empty() &&
           std::all_of(strikers.begin(), strikers.end(), [&](const btCollisionObject* striker) {
               const btRigidBody* body = btRigidBody::upcast(striker);
               return is_fragment_(*striker) && body && mass * body->getInvMass() >= light;
           });
}

void Patience::thinOut(const std::vector<StruckBreakable>& struck, double time_step_s, const StepSpent& spent,
                       GatedBlows& gated) const {
    if (budget_.shortest_wait_s == 0) return;
    const auto begin = gated.now.begin(), end = gated.now.end();
    const auto lasts = [&](std::size_t i) { return lastsWhileItWaits(struck[i], much_heavier); };
    const auto is_solved = [&](std::size_t i) { return gated.ahead[i].has_value(); };
    const auto solved = std::count_if(begin, end, is_solved);
    const auto to_solve = end - begin - solved;
    const int pieces = std::accumulate(
        begin, end, 0, [&](int sum, std::size_t i) { return sum + gated.ahead[i].value_or(0); });
    const bool are_many = spent.decided + to_solve > budget_.solves_per_step ||
                          (solved > 0 && spent.new_fragments + pieces > budget_.fragments_per_step);
    const bool is_crowd = are_many || spent.decided > 0 || !std::all_of(begin, end, lasts);
    // Free bodies of a crowd take their parts of a striker's speed all the same, whole or broken.
    const auto is_run_into = [&](std::size_t i) {
        return are_many && isRunInto(struck[i]) && !isBacked(struck[i]);
    };
    const auto must_not_wait = [&](std::size_t i) {
        if (is_run_into(i) || (are_many && fallsOnHeavy(struck[i]))) return false;
        if (!lasts(i)) return true;
        if (isStruckByFragmentsAlone(struck[i])) return false;
        // What stands under or behind the body that is struck breaks with it.
        return struck[i].blow.isSqueezed() ? !are_many : !is_crowd;
    };
    const auto may_wait = std::stable_partition(begin, end, must_not_wait);
    const auto unsolved = std::stable_partition(may_wait, end, is_solved);
    const auto others = std::stable_partition(unsolved, end, is_run_into);
    const auto is_more_urgent = [&](std::size_t a, std::size_t b) {
        return isMoreUrgent(struck[a], struck[b]);
    };
    std::stable_sort(may_wait, unsolved, is_more_urgent);
    std::stable_sort(unsolved, others, is_more_urgent);
    std::stable_sort(others, end, is_more_urgent);
    const Turns turns{static_cast<std::size_t>(may_wait - begin), static_cast<std::size_t>(others - begin),
                      is_crowd};
    constexpr double of_a_step = 0.5;  // Bullet takes part of it, too
    fillStep(struck, turns, of_a_step * millisecondsPerStep(budget_, time_step_s), spent, gated);
}

/// Decides which blows the step has room for: those of `gated.now`, in the order in which they get it.
void Patience::fillStep(const std::vector<StruckBreakable>& struck, const Turns& turns, double most_ms,
                        const StepSpent& spent, GatedBlows& gated) const {
    double ms = spent.decided_ms;
    int count = spent.decided, places = budget_.fragments_per_step - spent.new_fragments;
    // Those that have to be solved in this step are left a fair share of the places.
    const int share = std::max(fewest_fragments, places / std::max(1, static_cast<int>(gated.now.size())));
    bool others_wait = false;
    std::vector<std::size_t> now;
    for (std::size_t turn = 0; turn < gated.now.size(); ++turn) {
        const std::size_t i = gated.now[turn];
        const bool may_wait = turn >= turns.first_that_may_wait;
        const int pieces =
            gated.ahead[i].value_or(std::min(share, struck[i].breakable->fracture->largest_fragment_count));
        const bool has_places = pieces <= places;
        bool waits = may_wait && gated.ahead[i] && !has_places;
        if (!waits && !(gated.ahead[i] && has_places)) {
            gated.ahead[i].reset();
            ms += estimatedMilliseconds(*struck[i].breakable->asset.solid(), struck[i].blow);
            const bool has_no_solves = count >= budget_.solves_per_step;
            const bool may_be_none =
                (turns.is_crowd || isStruckByLightFragments(struck[i])) && !struck[i].is_of_explosion;
            const bool has_no_time = (ms > most_ms || has_no_solves) && (count > 0 || may_be_none);
            const bool has_no_room = turn < turns.first_that_needs_time ? has_no_solves : has_no_time;
            others_wait = others_wait || (may_wait && (has_no_room || !has_places));
            waits = others_wait;
            if (!waits) ++count;
        }
        if (!waits) places -= pieces;
        (waits ? gated.later : now).push_back(i);
    }
    gated.now = std::move(now);
    std::sort(gated.now.begin(), gated.now.end());
    std::sort(gated.later.begin(), gated.later.end());
}

void Patience::tearOutFirst(const std::vector<StruckBreakable>& struck, const StepSpent& spent,
                            GatedBlows& gated) const {
    if (budget_.shortest_wait_s == 0) return;
    const auto is_solved = [&](std::size_t i) { return !mayBeTornOut(struck[i]); };
    const auto begin = gated.now.begin(), end = gated.now.end();
    const auto rests = std::stable_partition(begin, end, is_solved);
    const auto solves =
        std::count_if(begin, rests, [&](std::size_t i) { return !gated.ahead[i].has_value(); });
    std::stable_sort(rests, end,
                     [&](std::size_t a, std::size_t b) { return isMoreUrgent(struck[a], struck[b]); });
    const auto left = std::max<std::ptrdiff_t>(0, budget_.solves_per_step - spent.decided - solves);
    const auto first = rests + std::min(left, end - rests);
    for (auto i = first; i != end; ++i) gated.torn[*i] = Torn::first;
    gated.now.erase(first, end);
    std::sort(gated.now.begin(), gated.now.end());
}

}  // namespace sherd
