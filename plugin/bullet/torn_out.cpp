#include "bullet/torn_out.h"

#include <utility>

namespace sherd {

namespace {

/// Whether the piece hardly slows down what strikes it there, or cannot.
bool isHeavyAgainst(const btCollisionObject& striker, double piece_kg) {
    constexpr double heavy = 4;  // times as heavy
    const btRigidBody* body = btRigidBody::upcast(&striker);
    if (!body || body->isKinematicObject()) return true;
    return body->getInvMass() > 0 && 1 / double(body->getInvMass()) >= heavy * piece_kg;
}

}  // namespace

bool isTornOut(const StruckBreakable& struck, double time_s) {
    const Breakable& piece = *struck.breakable;
    if (!piece.isHeldRest() || (time_s >= piece.young_until_s && piece.breaksAt(time_s))) return false;
    for (std::size_t p = 0; p < struck.partners.size(); ++p)
        if (struck.blow.isStruckBy(static_cast<int>(p)) && !struck.partners[p]->isStaticObject() &&
            isHeavyAgainst(*struck.partners[p], piece.asset.mass()))
            return true;
    return false;
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
