#include "bullet/strikes/striker_contacts.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>

namespace sherd {

void pushAsTheWholeWasStruck(btDispatcher& dispatcher, const StrikeOnWhole& strike,
                             const std::vector<btCollisionObject*>& pieces) {
    constexpr btScalar deep = btScalar(0.25);  // of the way
    constexpr btScalar alike = btScalar(0.7);  // cosine
    if (!strike.striker || !(strike.way_m > 0) || strike.push.isZero()) return;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const bool piece_is_a = manifold.getBody1() == strike.striker;
        if (!piece_is_a && manifold.getBody0() != strike.striker) continue;
        const btCollisionObject* piece = piece_is_a ? manifold.getBody0() : manifold.getBody1();
        if (std::find(pieces.begin(), pieces.end(), piece) == pieces.end()) continue;
        const btVector3 normal = piece_is_a ? strike.push : -strike.push;  // it pushes A
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            btManifoldPoint& point = manifold.getContactPoint(p);
            if (-point.getDistance() < deep * strike.way_m) continue;
            if (point.m_normalWorldOnB.dot(normal) >= alike) continue;
            point.m_normalWorldOnB = normal;
            point.setDistance(0);
        }
    }
}

}  // namespace sherd
