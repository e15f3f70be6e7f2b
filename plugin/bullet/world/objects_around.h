#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace sherd {

/// The objects of a world whose boxes touch a box, in the order of the world.
inline std::vector<const btCollisionObject*> objectsAround(btCollisionWorld& world, const btVector3& low,
                                                           const btVector3& high) {
    struct All final : btBroadphaseAabbCallback {
        bool process(const btBroadphaseProxy* proxy) override {
            objects.push_back(static_cast<const btCollisionObject*>(proxy->m_clientObject));
            return true;
        }
        std::vector<const btCollisionObject*> objects;
    } all;
    world.getBroadphase()->aabbTest(low, high, all);
    // That of Bullet's tree depends on addresses.
    std::sort(all.objects.begin(), all.objects.end(),
              [](const auto* a, const auto* b) { return a->getWorldArrayIndex() < b->getWorldArrayIndex(); });
    return std::move(all.objects);
}

}  // namespace sherd
