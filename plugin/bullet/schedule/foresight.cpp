#include "bullet/schedule/foresight.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <functional>
#include <unordered_map>
#include <utility>

#include "bullet/schedule/waiting_blows.h"
#include "bullet/world/simulated_time.h"
#include "core/numerics/stopwatch.h"

namespace sherd {

namespace {

constexpr int most_surprises = 3;
constexpr double shortest_rest_s = 0.25, longest_rest_s = 4;
constexpr btScalar off_the_way_m = btScalar(5e-4);
constexpr btScalar off_the_speed = btScalar(0.01);  // relative, and of a metre or a radian a second
// A ball alone takes 10 a step of the world, 60 are about half a millisecond.
constexpr int credit_per_step = 60, most_credit = 600;

bool isOnItsWay(const btRigidBody& body, const BodyState& foreseen) {
    const btScalar off = (body.getWorldTransform().getOrigin() - foreseen.transform.getOrigin()).length();
    const btScalar faster = (body.getLinearVelocity() - foreseen.linear).length();
    const btScalar turn = (body.getAngularVelocity() - foreseen.angular).length();
    return off <= off_the_way_m && faster <= off_the_speed * (1 + foreseen.linear.length()) &&
           turn <= off_the_speed * (1 + foreseen.angular.length());
}

/// What a blow takes on cores that are half as fast as the estimate has them, ms.
double workOf(const ForeseenBlow& blow) {
    constexpr double slower = 2;
    const BreakableSolid& solid = *blow.blow.solid;
    return slower * (estimatedMilliseconds(solid, blow.blow.blow) + setUpMilliseconds(solid));
}

/// The part of a blow's work that is to be waited for in a step, ms.
double shareOf(const ForeseenBlow& blow, double time_s, double time_step_s) {
    constexpr double left_alone =
        1.0 / 3;  // of the time there is: other threads are ahead of real time by then
    const double free_until_s = blow.found_at_s + left_alone * (blow.strikes_at_s - blow.found_at_s);
    const double left_s = blow.strikes_at_s - free_until_s;
    if (time_s < free_until_s || left_s <= time_step_s) return 0;
    return workOf(blow) * time_step_s / left_s;
}

/// The rigid bodies of a world that have a token.
std::unordered_map<BodyToken, const btRigidBody*> bodiesByToken(const btDiscreteDynamicsWorld& world) {
    std::unordered_map<BodyToken, const btRigidBody*> bodies;  // for look-up only
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (const BodyToken token = tokenOf(*objects[i]); token != no_token)
            bodies[token] = btRigidBody::upcast(objects[i]);
    return bodies;
}

}  // namespace

int Foresight::clear() {
    const auto count = static_cast<int>(blows_.size());
    outlooks_.clear();
    blows_.clear();
    busy_until_s_ = 0;
    return count;
}

Foresight::Outlook* Foresight::of(BodyToken mover) {
    const auto known = std::find_if(outlooks_.begin(), outlooks_.end(),
                                    [&](const Outlook& outlook) { return outlook.mover == mover; });
    return known == outlooks_.end() ? nullptr : &*known;
}

/// Of a body that does what nobody foresees for a while, that is looked at ever less often.
void Foresight::surprised(Outlook& outlook, double time_s) {
    if (++outlook.surprises < most_surprises) return;
    outlook.surprises = 0;
    outlook.rest_s = std::clamp(2 * outlook.rest_s, shortest_rest_s, longest_rest_s);
    outlook.rests_until_s = time_s + outlook.rest_s;
}

bool Foresight::strays(Outlook& outlook, const btRigidBody& body, double time_s) {
    if (outlook.way.empty()) return true;
    const bool knows_more = outlook.steps < outlook.way.size();
    if (knows_more && isOnItsWay(body, outlook.way[outlook.steps++])) return false;
    if (knows_more) surprised(outlook, time_s);
    outlook.way.clear();
    outlook.until_s = time_s;
    return true;
}

int Foresight::follow(const btDiscreteDynamicsWorld& world, double time_s) {
    credit_ = std::min(credit_ + credit_per_step, most_credit);
    if (empty()) return 0;
    const auto bodies = bodiesByToken(world);
    std::vector<BodyToken> strayed;
    for (Outlook& outlook : outlooks_) {
        const auto body = bodies.find(outlook.mover);
        const bool is_gone = body == bodies.end() || !body->second;
        if (is_gone) outlook.mover = no_token;
        if (is_gone || strays(outlook, *body->second, time_s)) strayed.push_back(outlook.mover);
    }
    const auto is_forgotten = [&](const Outlook& outlook) {
        const double since_s = std::max(outlook.until_s, outlook.rests_until_s);
        return outlook.mover == no_token ||
               (outlook.way.empty() && since_s + std::max(outlook.rest_s, shortest_rest_s) <= time_s);
    };
    outlooks_.erase(std::remove_if(outlooks_.begin(), outlooks_.end(), is_forgotten), outlooks_.end());
    const auto is_vain = [&](const ForeseenBlow& blow) {
        return blow.strikes_at_s <= time_s + time_rounding_s || !of(blow.mover) ||
               std::find(strayed.begin(), strayed.end(), blow.mover) != strayed.end();
    };
    const auto vain = std::stable_partition(blows_.begin(), blows_.end(), std::not_fn(is_vain));
    for (auto blow = blows_.end(); blow != vain;) leavePlan(*--blow, time_s);
    const auto count = static_cast<int>(blows_.end() - vain);
    blows_.erase(vain, blows_.end());
    return count;
}

bool Foresight::isToBeLookedAt(BodyToken mover, double time_s, double ahead_s) const {
    const auto known = std::find_if(outlooks_.begin(), outlooks_.end(),
                                    [&](const Outlook& outlook) { return outlook.mover == mover; });
    if (known == outlooks_.end()) return true;
    const bool strikes = std::any_of(blows_.begin(), blows_.end(),
                                     [&](const ForeseenBlow& blow) { return blow.mover == mover; });
    return !strikes && known->rests_until_s <= time_s && known->until_s < time_s + ahead_s;
}

void Foresight::note(BodyToken mover, std::vector<BodyState> way, double until_s, int cost,
                     bool is_too_dear) {
    credit_ -= cost;
    Outlook* outlook = of(mover);
    if (!outlook) {
        outlooks_.emplace_back();
        outlook = &outlooks_.back();
        outlook->mover = mover;
    }
    outlook->way = std::move(way);
    outlook->steps = 0;
    outlook->until_s = until_s;
    if (is_too_dear) surprised(*outlook, until_s);
}

void Foresight::note(ForeseenBlow blow, double turn_s) {
    busy_until_s_ = std::max(busy_until_s_, blow.found_at_s) + turn_s;
    blow.solved_by_s = busy_until_s_;
    blow.turn_s = turn_s;
    blows_.push_back(std::move(blow));
}

void Foresight::leavePlan(const ForeseenBlow& blow, double time_s) {
    const double left_s = std::clamp(blow.solved_by_s - time_s, 0.0, blow.turn_s);
    for (ForeseenBlow& other : blows_)
        if (other.solved_by_s > blow.solved_by_s) other.solved_by_s -= left_s;
    busy_until_s_ -= left_s;
}

bool Foresight::isForeseen(std::uint64_t serial) const {
    return std::any_of(blows_.begin(), blows_.end(),
                       [&](const ForeseenBlow& blow) { return blow.serial == serial; });
}

int Foresight::fullSolves() const {
    return static_cast<int>(std::count_if(blows_.begin(), blows_.end(),
                                          [](const ForeseenBlow& blow) { return blow.is_solved_in_full; }));
}

void Foresight::keepUp(double time_s, double time_step_s, int most_solves, double& waiting_ms) const {
    const bool are_many = static_cast<int>(blows_.size()) > most_solves;
    const auto is_worth_it = [&](const ForeseenBlow& blow) { return !are_many || blow.isSolvedInTime(); };
    double most_ms = 0;
    for (const ForeseenBlow& blow : blows_)
        if (is_worth_it(blow) && !blow.decided->isDecided()) most_ms += shareOf(blow, time_s, time_step_s);
    if (!(most_ms > 0)) return;
    const Stopwatch watch;
    // Other threads take the first ones: of many that fall together this one does some meanwhile.
    for (auto last = blows_.rbegin(); last != blows_.rend(); ++last)
        if (is_worth_it(*last) && workOf(*last) <= most_ms - watch.milliseconds())
            last->decided->decideIfFree();
    const double solved_here_ms = watch.milliseconds();  // which counts with the blows
    for (const ForeseenBlow& blow : blows_)
        if (const double left_ms = most_ms - watch.milliseconds(); left_ms > 0 && is_worth_it(blow))
            blow.decided->waitIfBegun(left_ms);
    waiting_ms += watch.milliseconds() - solved_here_ms;
}

void Foresight::workUntil(double time_s) const {
    double none = 0;  // nobody else does any
    for (const ForeseenBlow& blow : blows_)
        if (blow.isSolvedInTime() && blow.solved_by_s <= time_s + time_rounding_s) blow.decided->finish(none);
}

const ForeseenBlow* Foresight::find(const StruckBreakable& struck, const BlowToDecide& blow) const {
    const auto known = std::find_if(blows_.begin(), blows_.end(), [&](const ForeseenBlow& foreseen) {
        return isAsForeseen(foreseen, struck, blow);
    });
    return known == blows_.end() ? nullptr : &*known;
}

std::optional<ForeseenBlow> Foresight::take(const StruckBreakable& struck, const BlowToDecide& blow,
                                            double time_s) {
    const ForeseenBlow* const found = find(struck, blow);
    if (!found) return std::nullopt;
    leavePlan(*found, time_s);
    const auto known = blows_.begin() + (found - blows_.data());
    ForeseenBlow taken = std::move(*known);
    if (Outlook* outlook = of(taken.mover)) {
        outlook->surprises = 0;
        outlook->rest_s = 0;
        outlook->way.clear();  // it goes on another way
        outlook->until_s = 0;
    }
    blows_.erase(known);
    return taken;
}

}  // namespace sherd
