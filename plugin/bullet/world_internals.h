#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

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
};

}  // namespace sherd
