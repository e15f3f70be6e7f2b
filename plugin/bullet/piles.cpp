#include "bullet/piles.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <utility>

#include "bullet/contact_motion.h"
#include "bullet/same_blow.h"

namespace sherd {

namespace {

constexpr std::size_t most_bodies = 12;

}  // namespace

Piles::Piles(const std::vector<const btPersistentManifold*>& solved,
             const std::vector<const btPersistentManifold*>& predictive, const BreakableRegistry& breakables,
             const StepSnapshot& before, double time_s, double time_step_s)
    : breakables_(breakables), before_(before), time_s_(time_s), time_step_s_(time_step_s) {
    std::vector<Strike> strikes;
    std::vector<const btPersistentManifold*> pressed;
    for (const btPersistentManifold* manifold : solved) {
        const bool foreseen = std::find(predictive.begin(), predictive.end(), manifold) != predictive.end();
        look(*manifold, foreseen, strikes, pressed);
    }
    if (!landed_.empty())
        for (const btPersistentManifold* manifold : pressed) {
            noteRider(*manifold->getBody0(), *manifold->getBody1());
            noteRider(*manifold->getBody1(), *manifold->getBody0());
        }
    if (strikes.empty()) return;
    Neighbours neighbours;
    for (const btPersistentManifold* manifold : pressed)
        for (const btCollisionObject* object : {manifold->getBody0(), manifold->getBody1()})
            if (givesWay(*object)) neighbours[object].push_back(manifold);
    for (const Strike& strike : strikes)
        if (neighbours.count(strike.struck)) assign(pileOf(strike, neighbours));
}

void Piles::look(const btPersistentManifold& manifold, bool is_predictive, std::vector<Strike>& strikes,
                 std::vector<const btPersistentManifold*>& pressed) {
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    const BodyState *before_a = before_.find(a), *before_b = before_.find(b);
    Strike on_a{b, a, {}, {}, 0, 0, -1, -1};
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
        if (!(closing > slowestStrike(of_a, of_b, time_step_s_))) continue;
        const double speed = speedOfTouch(closing, of_b.fall - of_a.fall, -point.getDistance(), time_step_s_);
        if (speed <= on_a.speed_m_s) continue;
        on_a = {b,
                a,
                place,
                push,
                speed,
                0,
                is_predictive ? -1 : point.m_index1,
                is_predictive ? -1 : point.m_index0};
    }
    if (!(impulse > 0)) return;
    if (!(on_a.speed_m_s > 0)) {
        if (!is_predictive) pressed.push_back(&manifold);
        return;
    }
    const Strike on_b{a, b, on_a.point, -on_a.push, on_a.speed_m_s, 0, on_a.struck_child, on_a.striker_child};
    for (Strike strike : {on_a, on_b}) {
        const Breakable *struck = breakables_.of(*strike.struck), *by = breakables_.of(*strike.striker);
        if (!givesWay(*strike.struck)) continue;
        if (!givesWay(*strike.striker)) {
            noteLanding(strike);
            continue;
        }
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

void Piles::noteRider(const btCollisionObject& rider, const btCollisionObject& carrier) {
    const auto landed = landed_.find(&carrier);
    const Breakable* breakable = breakables_.of(rider);
    if (landed == landed_.end() || !breakable || !givesWay(rider)) return;
    const double energy = 0.5 * breakable->asset.solid()->mass() * landed->second * landed->second;
    if (energy >= breakable->least_energy_j) riding_.insert(&rider);
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
            const bool is_known =
                std::find(pile.bodies.begin(), pile.bodies.end(), other) != pile.bodies.end();
            if (!is_known && givesWay(*other)) {
                if (pile.bodies.size() == most_bodies) continue;
                pile.bodies.push_back(other);
            }
            if (std::find(pile.contacts.begin(), pile.contacts.end(), manifold) == pile.contacts.end())
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
    if (found != pile_of_.end()) struck.blow.stack = stackOf(piles_[found->second], struck);
}

}  // namespace sherd
