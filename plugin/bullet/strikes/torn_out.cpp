#include "bullet/strikes/torn_out.h"

#include <algorithm>
#include <utility>

#include "bullet/island/contact_motion.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double heavy = 2;  // times as heavy: the one hardly slows down the other
constexpr double trifle = 0.01;

/// 0 of what does not give way: it goes on through nothing.
double movingMass(const btCollisionObject& object) {
    const Mobility mobility =
        mobilityOf(object, btTransform::getIdentity(), object.getWorldTransform().getOrigin());
    return mobility.inverse_mass > 0 ? 1 / mobility.inverse_mass : 0;
}

/// The share of what a partner moves with that the body takes from it.
double takenShare(const Blow& blow, int partner, double mass_kg) {
    double impulse = 0, speed = 0;
    for (const ContactImpulse& contact : blow.contacts) {
        if (contact.partner != partner) continue;
        impulse += std::max(0.0, contact.pushed());
        speed = std::max(speed, contact.approach_m_s);
    }
    return impulse > 0 ? impulse / (mass_kg * speed) : 0;
}

/// What of a rest is in the way of a striker, kg: a ball breaks as much of a pane as it needs to get through.
double massInTheWay(const Breakable& rest, const btCollisionObject& striker) {
    btVector3 low, high;
    striker.getCollisionShape()->getAabb(btTransform::getIdentity(), low, high);
    const btScalar radius = (high - low).dot(btVector3(1, 1, 1)) / 6;  // in the mean
    const BreakableSolid& solid = *rest.asset.solid();
    const double wall = solid.wallThickness(), reach = static_cast<double>(radius) + wall;
    return std::min(solid.mass(), solid.material().density_kg_m3 * wall * pi * reach * reach);
}

/// A striker of that mass breaks a rest.
double breakingMass(const Breakable& rest, const btCollisionObject& striker) {
    return massInTheWay(rest, striker) / heavy;
}

/// One of that mass tears it out of its supports: a rest that may not break gives way in no other way.
double tearingMass(const Breakable& rest, const btCollisionObject& striker) {
    return rest.mayBreak() ? heavy * rest.asset.mass() : breakingMass(rest, striker);
}

/// The largest share that is taken from a partner of that mass or more; below zero if none strikes.
template <class LeastMass>
double takenOf(const StruckBreakable& rest, LeastMass least_mass) {
    double taken = -1;
    for (std::size_t p = 0; p < rest.partners.size(); ++p) {
        const int number = static_cast<int>(p);
        const btCollisionObject& partner = *rest.partners[p];
        const double mass_kg = movingMass(partner);
        if (mass_kg >= least_mass(*rest.breakable, partner) && rest.blow.isStruckBy(number))
            taken = std::max(taken, takenShare(rest.blow, number, mass_kg));
    }
    return taken;
}

}  // namespace

bool goesOnThrough(const Breakable& rest, const btCollisionObject& striker, const Breakable* breakable,
                   double time_s) {
    return rest.isHeldRest() && !(breakable && time_s < breakable->young_until_s) &&
           movingMass(striker) >= breakingMass(rest, striker);
}

bool isLightRest(const StruckBreakable& struck, double time_s) {
    const Breakable& piece = *struck.breakable;
    const bool may_break = time_s >= piece.young_until_s && piece.breaksAt(time_s);
    return piece.isHeldRest() && !may_break && takenOf(struck, tearingMass) >= 0;
}

bool isInTheWay(const StruckBreakable& light_rest) {
    return takenOf(light_rest, tearingMass) > trifle;
}

bool mayBeTornOut(const StruckBreakable& struck) {
    return struck.breakable->isHeldRest() && takenOf(struck, breakingMass) > trifle;
}

std::shared_ptr<DecidedBlow> tornOut(const StruckBreakable& struck) {
    const Breakable& piece = *struck.breakable;
    BlowOutcome outcome;
    outcome.outcome = Outcome::broke;
    outcome.level = Level::gate;
    outcome.impulse_n_s = normalImpulse(struck.blow);
    outcome.message = "what was left of the body was torn out of its supports";
    outcome.fragments.push_back({piece.asset.solid()->anchored({}), {}});
    return DecidedBlow::decided(std::move(outcome), {piece.owned.shape});
}

}  // namespace sherd
