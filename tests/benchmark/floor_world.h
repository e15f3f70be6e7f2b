#pragma once

#include <btBulletDynamicsCommon.h>

namespace sherd::benchmarks {

inline constexpr double gravity_m_s2 = 9.81;

/// A world with a stone floor at z = 0.
struct FloorWorld {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    btBoxShape floor_shape;
    btRigidBody floor{0, nullptr, &floor_shape};

    explicit FloorWorld(btScalar half_length = 5) : floor_shape(btVector3(half_length, half_length, 0.5)) {
        floor.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -0.5)));
        world.addRigidBody(&floor);
        world.setGravity(btVector3(0, 0, btScalar(-gravity_m_s2)));
    }
    ~FloorWorld() { world.removeRigidBody(&floor); }
};

}  // namespace sherd::benchmarks
