#include "bullet/world/impulse_write_back.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

namespace sherd {

void ImpulseWriteBack::begin(btDiscreteDynamicsWorld& world) {
    btContactSolverInfo& info = world.getSolverInfo();
    forced_ = !(info.m_solverMode & SOLVER_USE_WARMSTARTING);
    if (!forced_) return;
    apps_factor_ = static_cast<float>(info.m_warmstartingFactor);
    info.m_solverMode |= SOLVER_USE_WARMSTARTING;
    info.m_warmstartingFactor = 0;
}

void ImpulseWriteBack::end(btDiscreteDynamicsWorld& world) {
    if (!forced_) return;
    forced_ = false;
    btContactSolverInfo& info = world.getSolverInfo();
    info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    info.m_warmstartingFactor = apps_factor_;
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            btManifoldPoint& point = manifold.getContactPoint(p);
            point.m_appliedImpulse = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
        }
    }
}

}  // namespace sherd
