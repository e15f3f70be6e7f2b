#pragma once

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

namespace sherd {

/// A floor, and a steel ball of 2 kg on its way at 12 m/s to where `addCups` puts 30 bodies. Outlives the
/// FractureWorld of its world.
struct CupRoom {
    static constexpr int per_row = 6, count = 30;
    static constexpr btScalar spacing_m = 0.13f;

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    btBoxShape slab{btVector3(5, 5, 0.5f)};
    btSphereShape sphere{0.05f};
    btRigidBody floor{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &slab)};
    btRigidBody ball{2, nullptr, &sphere, btVector3(0.002f, 0.002f, 0.002f)};

    CupRoom() {
        world.setGravity(btVector3(0, 0, -9.81f));
        floor.translate(btVector3(0, 0, -0.5f));
        world.addRigidBody(&floor);
        ball.translate(btVector3(-0.3f, 0.02f, 0.06f));
        ball.setLinearVelocity(btVector3(12, 0, 0));
        world.addRigidBody(&ball);
    }
    ~CupRoom() {
        world.removeRigidBody(&ball);
        world.removeRigidBody(&floor);
    }
    CupRoom(const CupRoom&) = delete;
    CupRoom& operator=(const CupRoom&) = delete;

    static Status addCups(FractureWorld& fracture, const BreakableAsset& cup) {
        for (int i = 0; i < count; ++i) {
            const btVector3 place(spacing_m * btScalar(i % per_row), spacing_m * btScalar(i / per_row - 2),
                                  0.001f);
            const auto added = fracture.add(cup, btTransform(btQuaternion::getIdentity(), place));
            if (!added) return Error{added.error()};
        }
        return success();
    }
};

}  // namespace sherd
