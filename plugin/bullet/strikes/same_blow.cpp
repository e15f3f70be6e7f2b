#include "bullet/strikes/same_blow.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>

namespace sherd {

std::vector<BodyToken> partOfTheBlowOn(btDiscreteDynamicsWorld& world, const btRigidBody& whole) {
    std::vector<BodyToken> bodies{tokenOf(whole)};
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const bool is_a = manifold.getBody0() == &whole;
        if ((!is_a && manifold.getBody1() != &whole) || manifold.getNumContacts() == 0) continue;
        const btCollisionObject* other = is_a ? manifold.getBody1() : manifold.getBody0();
        const BodyToken token = giveToken(*const_cast<btCollisionObject*>(other));
        if (token != no_token) bodies.push_back(token);
    }
    return bodies;
}

void noteBlow(const std::vector<BodyToken>& bodies, const Breakable& whole, double time_s, Breakable& piece) {
    piece.came_of = whole.came_of;
    piece.came_of.push_back(whole.token);
    for (const Breakable::Company& one : whole.in_one_blow_with)
        if (time_s < one.until_s) piece.in_one_blow_with.push_back(one);
    const double until_s = time_s + whole.fracture->same_blow_s;
    for (const BodyToken token : bodies) piece.in_one_blow_with.push_back({token, until_s});
    piece.young_until_s = until_s;
}

bool isOfTheSameBlow(const Breakable& piece, const btCollisionObject& other, const Breakable* breakable,
                     double time_s) {
    if (time_s >= piece.young_until_s) return false;
    if (breakable && time_s < breakable->young_until_s) return true;
    const auto is = [&](BodyToken token) {
        if (tokenOf(other) == token) return true;
        return breakable && std::find(breakable->came_of.begin(), breakable->came_of.end(), token) !=
                                breakable->came_of.end();
    };
    return std::any_of(piece.in_one_blow_with.begin(), piece.in_one_blow_with.end(),
                       [&](const auto& one) { return time_s < one.until_s && is(one.body); });
}

}  // namespace sherd
