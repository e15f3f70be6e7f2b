#include "bullet/strikes/piles.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <utility>

#include "bullet/island/contact_motion.h"
#include "bullet/strikes/same_blow.h"
#include "bullet/world/conversions.h"
#include "bullet/world/extra_contacts.h"

namespace sherd {

namespace {

constexpr std::size_t most_bodies = 12;
constexpr double own_part = 0.5;    // of a meeting's speed: what brings it lands on the other
constexpr double whole_part = 0.8;  // of a striker's speed: without it no strike is left

}  // namespace

Piles::Piles(const std::vector<const btPersistentManifold*>& solved,
             const std::vector<const btPersistentManifold*>& predictive, const BreakableRegistry& breakables,
             const StepSnapshot& before, double time_s, double time_step_s)
    : breakables_(breakables), before_(before), time_s_(time_s), time_step_s_(time_step_s) {
    std::vector<Strike> strikes;
    std::vector<const btPersistentManifold*> pressed;
    for (const btPersistentManifold* manifold : solved) {
        look(*manifold, isAmong(predictive, manifold), strikes, pressed);
    }
    if (!landed_.empty()) noteRiders(pressed);
    leaveOutFaint(strikes);
    if (strikes.empty()) return;
    Neighbours neighbours;
    for (const btPersistentManifold* manifold : pressed)
        for (const btCollisionObject* object : {manifold->getBody0(), manifold->getBody1()})
            if (givesWay(*object)) neighbours[object].push_back(manifold);
    for (const Strike& strike : strikes)
        if (neighbours.count(strike.struck)) assign(pileOf(strike, neighbours));
}

/// Those that break no body of the world; in a crowd nearly all.
void Piles::leaveOutFaint(std::vector<Strike>& strikes) const {
    const double least_j = breakables_.leastEnergyInWorld();
    strikes.erase(std::remove_if(strikes.begin(), strikes.end(),
                                 [&](const Strike& strike) { return strike.energy_j < least_j; }),
                  strikes.end());
}

void Piles::look(const btPersistentManifold& manifold, bool is_predictive, std::vector<Strike>& strikes,
                 std::vector<const btPersistentManifold*>& pressed) {
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    const BodyState *before_a = before_.find(a), *before_b = before_.find(b);
    Strike on_a;
    on_a.striker = b;
    on_a.struck = a;
    double speed_of_a = 0, speed_of_b = 0;  // towards each other
    btScalar impulse = 0;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        impulse += point.m_appliedImpulse;
        const btVector3 push = point.m_normalWorldOnB;
        btVector3 place = point.getPositionWorldOnA();
        if (is_predictive) place -= push * a->getCcdSweptSphereRadius();
        const PointMotion of_a = motionAt(*a, before_a, place, push, time_step_s_),
                          of_b = motionAt(*b, before_b, place, push, time_step_s_);
        const double closing = (of_b.velocity - of_a.velocity).dot(push);
        const double slowest = slowestStrike(of_a, of_b, time_step_s_), depth = -point.getDistance();
        const bool is_set_down = isSetDown(*a, *b, closing, depth, slowest, time_step_s_) ||
                                 isSetDown(*b, *a, closing, depth, slowest, time_step_s_);
        if (!is_set_down && !(closing > slowest)) continue;
        const double speed = speedOfTouch(closing, of_b.fall - of_a.fall, -point.getDistance(), time_step_s_);
        const double touched_s = timeSinceTouch(closing, -point.getDistance(), time_step_s_);
        noteStop(*a, *b, {place, push, speed, touched_s});
        noteStop(*b, *a, {place, -push, speed, touched_s});
        if (speed <= on_a.speed_m_s) continue;
        on_a.point = place;
        on_a.push = push;
        on_a.speed_m_s = speed;
        on_a.touched_s = touched_s;
        on_a.striker_child = is_predictive ? -1 : point.m_index1;
        on_a.struck_child = is_predictive ? -1 : point.m_index0;
        speed_of_a = -of_a.velocity.dot(push);
        speed_of_b = of_b.velocity.dot(push);
    }
    if (!(on_a.speed_m_s > 0)) {
        if (impulse > 0 && !is_predictive) pressed.push_back(&manifold);
        return;
    }
    if (!(impulse > 0 || on_a.touched_s > 0)) return;  // went by
    on_a.is_brought = speed_of_a >= own_part * on_a.speed_m_s;
    Strike on_b = on_a;
    std::swap(on_b.striker, on_b.struck);
    std::swap(on_b.striker_child, on_b.struck_child);
    on_b.push = -on_a.push;
    on_b.is_brought = speed_of_b >= own_part * on_a.speed_m_s;
    for (Strike strike : {on_a, on_b}) {
        const Breakable *struck = breakables_.of(*strike.struck), *by = breakables_.of(*strike.striker);
        if (!givesWay(*strike.struck)) continue;
        const bool is_stopped = !givesWay(*strike.striker);
        if (is_stopped || strike.is_brought) noteLanding(strike);
        if (is_stopped) continue;
        if (struck && isOfTheSameBlow(*struck, *strike.striker, by, time_s_)) continue;
        const double mass = 1 / double(btRigidBody::upcast(strike.striker)->getInvMass());
        strike.energy_j = 0.5 * mass * strike.speed_m_s * strike.speed_m_s;
        strikes.push_back(strike);
    }
}

/// Heaps of fragments land all the time.
void Piles::noteLanding(const Strike& strike) {
    if (breakables_.isFragment(*strike.struck)) return;
    double& speed = landed_[strike.struck];
    speed = std::max(speed, strike.speed_m_s);
}

void Piles::noteRiders(const std::vector<const btPersistentManifold*>& pressed) {
    bool goes_on = true;
    for (std::size_t level = 0; goes_on && level < most_bodies; ++level) {
        goes_on = false;
        for (const btPersistentManifold* manifold : pressed) {
            const btCollisionObject *a = manifold->getBody0(), *b = manifold->getBody1();
            if (noteRider(*a, *b)) goes_on = true;
            if (noteRider(*b, *a)) goes_on = true;
        }
    }
}

bool Piles::noteRider(const btCollisionObject& rider, const btCollisionObject& carrier) {
    const auto landed = landed_.find(&carrier);
    if (landed == landed_.end() || !givesWay(rider)) return false;
    const double speed = landed->second;
    if (const Breakable* breakable = breakables_.of(rider)) {
        const double energy = 0.5 * breakable->asset.solid()->mass() * speed * speed;
        if (energy >= breakable->least_energy_j) riding_.insert(&rider);
    }
    if (breakables_.isFragment(rider)) return false;
    double& known = landed_[&rider];
    return std::exchange(known, std::max(known, speed)) < speed;
}

void Piles::noteStop(const btCollisionObject& stopped, const btCollisionObject& by, const Stop& stop) {
    // What may break does not hold it up for sure.
    if (stop.touched_s > 0 && givesWay(stopped) && !givesWay(by) && !breakables_.of(by))
        stops_[&stopped].push_back(stop);
}

bool Piles::isStoppedBefore(const btCollisionObject& striker, const btVector3& place, const btVector3& push,
                            double touched_s, double closing_m_s) const {
    constexpr int rounds = 20;
    const auto stops = stops_.find(&striker);
    if (stops == stops_.end()) return false;
    const Mobility mobility = mobilityOf(striker, btTransform::getIdentity(), place);
    struct Row {
        Wrench wrench, response;
        double speed_m_s, impulse;
    };
    std::vector<Row> rows;
    for (const Stop& stop : stops->second) {
        if (!((stop.touched_s - touched_s) * closing_m_s > largestRestingGap())) continue;
        const Wrench wrench = mobility.wrench(fromBullet(stop.place), fromBullet(stop.push));
        rows.push_back({wrench, mobility.response(wrench), stop.speed_m_s, 0});
    }
    // All of them stop it together, and none pulls (projected Gauss-Seidel).
    Wrench motion = Wrench::Zero();
    for (int round = 0; round < rounds; ++round)
        for (Row& row : rows) {
            const double more = (row.speed_m_s - row.wrench.dot(motion)) / row.wrench.dot(row.response);
            const double before = std::exchange(row.impulse, std::max(0.0, row.impulse + more));
            motion += (row.impulse - before) * row.response;
        }
    const Wrench here = mobility.wrench(fromBullet(place), fromBullet(push));
    return here.dot(motion) >= whole_part * closing_m_s;
}

Piles::Pile Piles::pileOf(const Strike& strike, const Neighbours& neighbours) const {
    Pile pile{strike, {strike.struck}, {}};
    for (std::size_t next = 0; next < pile.bodies.size(); ++next) {
        const auto touching = neighbours.find(pile.bodies[next]);
        if (touching == neighbours.end()) continue;
        for (const btPersistentManifold* manifold : touching->second) {
            const btCollisionObject* other =
                manifold->getBody0() == pile.bodies[next] ? manifold->getBody1() : manifold->getBody0();
            if (other == strike.striker) continue;
            const auto known = std::find(pile.bodies.begin(), pile.bodies.end(), other);
            const auto place = static_cast<std::size_t>(known - pile.bodies.begin());
            if (place < next) continue;  // that one has brought it
            if (place == pile.bodies.size() && givesWay(*other)) {
                if (pile.bodies.size() == most_bodies) continue;
                pile.bodies.push_back(other);
            }
            pile.contacts.push_back(manifold);
        }
    }
    return pile;
}

void Piles::assign(Pile pile) {
    if (pile.bodies.size() < 2) return;  // what does not give way is all that holds the struck body
    bool is_heard = false;
    for (const btCollisionObject* body : pile.bodies) {
        const Breakable* breakable = breakables_.of(*body);
        if (!breakable || pile.strike.energy_j < breakable->least_energy_j) continue;
        is_heard = true;
        const auto [place, is_new] = pile_of_.try_emplace(body, piles_.size());
        if (!is_new && piles_[place->second].strike.energy_j < pile.strike.energy_j)
            place->second = piles_.size();
    }
    if (is_heard) piles_.push_back(std::move(pile));
}

bool Piles::mayBreak(const Breakable& breakable) const {
    return pile_of_.count(breakable.body) > 0 || riding_.count(breakable.body) > 0;
}

void Piles::attachTo(StruckBreakable& struck) const {
    const auto found = pile_of_.find(struck.breakable->body);
    if (found == pile_of_.end()) return;
    struck.blow.stack = stackOf(piles_[found->second], struck);
    if (!struck.blow.stack.strike.strikes()) return;
    const BroughtBound own = broughtAtMost(struck.blow, struck.breakable->asset.solid()->mass(), true);
    if (!own.is_sure || own.energy_j >= struck.breakable->least_energy_j) return;
    for (ContactImpulse& contact : struck.blow.contacts)
        contact.approach_m_s = std::min(contact.approach_m_s, 0.0);
}

}  // namespace sherd
