#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

namespace sherd {

/// Whether the app lets two objects of a world touch: by groups and masks or its own filter, and by what is
/// set for the pair. They may be asleep.
inline bool mayMeet(btDiscreteDynamicsWorld& world, const btCollisionObject& a, const btCollisionObject& b) {
    auto* proxy_a = const_cast<btBroadphaseProxy*>(a.getBroadphaseHandle());
    auto* proxy_b = const_cast<btBroadphaseProxy*>(b.getBroadphaseHandle());
    return proxy_a && proxy_b && world.getPairCache()->needsBroadphaseCollision(proxy_a, proxy_b) &&
           a.checkCollideWith(&b) && b.checkCollideWith(&a);
}

/// Whether the world lets two of its objects push each other, by all filters of Bullet's.
inline bool pushEachOther(btDiscreteDynamicsWorld& world, const btCollisionObject& a,
                          const btCollisionObject& b) {
    auto* proxy_a = const_cast<btBroadphaseProxy*>(a.getBroadphaseHandle());
    auto* proxy_b = const_cast<btBroadphaseProxy*>(b.getBroadphaseHandle());
    btDispatcher& dispatcher = *world.getDispatcher();
    return world.getPairCache()->needsBroadphaseCollision(proxy_a, proxy_b) &&
           dispatcher.needsCollision(&a, &b) && dispatcher.needsResponse(&a, &b);
}

}  // namespace sherd
