#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

namespace sherd {

/// Protected members of btDiscreteDynamicsWorld that have no accessor: a derived class may name them, and a
/// pointer to member works on any world.
class WorldInternals : private btDiscreteDynamicsWorld {
  public:
    WorldInternals() = delete;
    static bool& ownsSolver(btDiscreteDynamicsWorld& world) {
        return world.*(&WorldInternals::m_ownsConstraintSolver);
    }
    static btAlignedObjectArray<btPersistentManifold*>& predictiveManifolds(btDiscreteDynamicsWorld& world) {
        return world.*(&WorldInternals::m_predictiveManifolds);
    }
    static btInternalTickCallback& beforeSteps(btDiscreteDynamicsWorld& world) {
        return world.*(&WorldInternals::m_internalPreTickCallback);
    }
    static btAlignedObjectArray<btActionInterface*>& actions(btDiscreteDynamicsWorld& world) {
        return world.*(&WorldInternals::m_actions);
    }
};

/// Compares pointers only: the object may be dead.
inline bool isInWorld(const btDiscreteDynamicsWorld& world, const btCollisionObject* object) {
    const auto& objects = world.getCollisionObjectArray();
    return objects.findLinearSearch(const_cast<btCollisionObject*>(object)) != objects.size();
}

}  // namespace sherd
