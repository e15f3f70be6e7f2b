#include "bullet/world/extra_contacts.h"

#include <algorithm>
#include <functional>

#include "bullet/world/world_internals.h"

namespace sherd {

namespace {

constexpr int mark = 0x53686572;  // in a field of Bullet's that nothing of it uses

}  // namespace

btPersistentManifold* addExtraManifold(btDiscreteDynamicsWorld& world, const btCollisionObject& a,
                                       const btCollisionObject& b) {
    btPersistentManifold* manifold = world.getDispatcher()->getNewManifold(&a, &b);
    if (!manifold) return nullptr;
    manifold->m_companionIdA = mark;
    WorldInternals::predictiveManifolds(world).push_back(manifold);
    return manifold;
}

bool isExtra(const btPersistentManifold& manifold) {
    return manifold.m_companionIdA == mark;
}

void releaseExtraManifolds(btDiscreteDynamicsWorld& world) {
    auto& manifolds = WorldInternals::predictiveManifolds(world);
    for (int i = manifolds.size() - 1; i >= 0; --i) {
        btPersistentManifold* manifold = manifolds[i];
        if (!isExtra(*manifold)) continue;
        manifolds.removeAtIndex(i);
        manifold->setNumContacts(0);
        world.getDispatcher()->releaseManifold(manifold);
    }
}

std::vector<const btPersistentManifold*> predictiveContacts(btDiscreteDynamicsWorld& world) {
    const auto& predictive = WorldInternals::predictiveManifolds(world);
    std::vector<const btPersistentManifold*> foreseen;
    for (int i = 0; i < predictive.size(); ++i)
        if (!isExtra(*predictive[i])) foreseen.push_back(predictive[i]);
    std::sort(foreseen.begin(), foreseen.end(), std::less<>());
    return foreseen;
}

bool isAmong(const std::vector<const btPersistentManifold*>& predictive,
             const btPersistentManifold* manifold) {
    return std::binary_search(predictive.begin(), predictive.end(), manifold, std::less<>());
}

}  // namespace sherd
