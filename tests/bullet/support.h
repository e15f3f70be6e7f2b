#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btDefaultSoftBodySolver.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>
#include <sherd/sherd.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "support/shapes.h"

namespace sherd::bullet_tests {

enum class WorldKind { plain, owns_its_solver, threaded, soft, multi_body };

/// A world with all that Bullet wants beside it. No gravity unless it is set.
struct TestWorld {
    explicit TestWorld(WorldKind kind = WorldKind::plain) {
        if (kind == WorldKind::threaded) btSetTaskScheduler(btGetSequentialTaskScheduler());
        broadphase = std::make_unique<btDbvtBroadphase>();
        if (kind == WorldKind::soft)
            configuration = std::make_unique<btSoftBodyRigidBodyCollisionConfiguration>();
        else
            configuration = std::make_unique<btDefaultCollisionConfiguration>();
        if (kind == WorldKind::threaded)
            dispatcher = std::make_unique<btCollisionDispatcherMt>(configuration.get());
        else
            dispatcher = std::make_unique<btCollisionDispatcher>(configuration.get());
        makeWorld(kind);
        world->setGravity(btVector3(0, 0, 0));
    }

    ~TestWorld() {
        for (int i = world->getNumConstraints() - 1; i >= 0; --i)
            world->removeConstraint(world->getConstraint(i));
        for (int i = world->getNumCollisionObjects() - 1; i >= 0; --i)
            world->removeCollisionObject(world->getCollisionObjectArray()[i]);
    }

    btRigidBody* addBody(std::unique_ptr<btCollisionShape> shape, double mass, const btVector3& position) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(btScalar(mass), inertia);
        bodies.push_back(std::make_unique<btRigidBody>(btScalar(mass), nullptr, shape.get(), inertia));
        shapes.push_back(std::move(shape));
        btRigidBody* body = bodies.back().get();
        body->setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), position));
        world->addRigidBody(body);
        return body;
    }
    btRigidBody* addBall(double mass, double radius, const btVector3& position,
                         const btVector3& velocity = {0, 0, 0}) {
        btRigidBody* ball = addBody(std::make_unique<btSphereShape>(btScalar(radius)), mass, position);
        ball->setLinearVelocity(velocity);
        return ball;
    }
    btRigidBody* addBox(double mass, const btVector3& half_extents, const btVector3& position) {
        return addBody(std::make_unique<btBoxShape>(half_extents), mass, position);
    }
    /// A floor whose upper face is z = 0.
    btRigidBody* addFloor() { return addBox(0, btVector3(5, 5, 0.5), btVector3(0, 0, -0.5)); }

    void step(int count = 1, double dt = 1.0 / 240) {
        for (int i = 0; i < count; ++i) world->stepSimulation(btScalar(dt), 0);
    }

    std::unique_ptr<btCollisionConfiguration> configuration;
    std::unique_ptr<btCollisionDispatcher> dispatcher;
    std::unique_ptr<btBroadphaseInterface> broadphase;
    std::unique_ptr<btConstraintSolver> solver, island_solver;
    std::unique_ptr<btSoftBodySolver> soft_solver;
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    std::unique_ptr<btDiscreteDynamicsWorld> world;

  private:
    void makeWorld(WorldKind kind) {
        if (kind == WorldKind::threaded) {
            auto pool = std::make_unique<btConstraintSolverPoolMt>(2);
            island_solver = std::make_unique<btSequentialImpulseConstraintSolver>();
            world = std::make_unique<btDiscreteDynamicsWorldMt>(
                dispatcher.get(), broadphase.get(), pool.get(), island_solver.get(), configuration.get());
            solver = std::move(pool);
            return;
        }
        if (kind == WorldKind::multi_body) {
            auto multi = std::make_unique<btMultiBodyConstraintSolver>();
            world = std::make_unique<btMultiBodyDynamicsWorld>(dispatcher.get(), broadphase.get(),
                                                               multi.get(), configuration.get());
            solver = std::move(multi);
            return;
        }
        if (kind != WorldKind::owns_its_solver)
            solver = std::make_unique<btSequentialImpulseConstraintSolver>();
        if (kind == WorldKind::soft) {
            soft_solver = std::make_unique<btDefaultSoftBodySolver>();
            world = std::make_unique<btSoftRigidDynamicsWorld>(
                dispatcher.get(), broadphase.get(), solver.get(), configuration.get(), soft_solver.get());
            return;
        }
        world = std::make_unique<btDiscreteDynamicsWorld>(dispatcher.get(), broadphase.get(), solver.get(),
                                                          configuration.get());
    }
};

/// Breaks at a touch.
inline Material crumbly() {
    Material material = Material::plaster();
    material.tensile_strength_pa = 1e3;
    return material;
}

/// Breaks under no blow of these tests.
inline Material unbreakable() {
    Material material = Material::plaster();
    material.tensile_strength_pa = 1e13;
    return material;
}

/// Coarse, so that a test takes milliseconds.
inline Settings coarse(double spacing_m) {
    Settings settings;
    settings.sampling.spacing_m = spacing_m;
    settings.fracture.fragment_count = 8;
    settings.fracture.smallest_fragment_m3 = 0.006;  // pieces of these tests' bodies do not break again
    return settings;
}

/// A plate of 0.6 x 0.6 x 0.06 m in the x-y plane about the origin.
inline BreakableAsset plate(const Material& material, double spacing_m = 0.06) {
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                material, coarse(spacing_m));
    EXPECT_TRUE(asset.ok()) << asset.error();
    return asset.value();
}

inline btTransform at(btScalar x, btScalar y, btScalar z) {
    return btTransform(btQuaternion::getIdentity(), btVector3(x, y, z));
}

inline bool sameBits(const btVector3& a, const btVector3& b) {
    return std::memcmp(&a, &b, 3 * sizeof(btScalar)) == 0;
}

inline bool sameState(const btRigidBody& a, const btRigidBody& b) {
    const btTransform &p = a.getWorldTransform(), &q = b.getWorldTransform();
    bool same = sameBits(p.getOrigin(), q.getOrigin());
    for (int row = 0; row < 3; ++row) same = same && sameBits(p.getBasis()[row], q.getBasis()[row]);
    return same && sameBits(a.getLinearVelocity(), b.getLinearVelocity()) &&
           sameBits(a.getAngularVelocity(), b.getAngularVelocity());
}

/// Whether a warning of the event has these words.
inline bool warnsOf(const BlowEvent& event, const char* words) {
    return std::any_of(event.warnings.begin(), event.warnings.end(),
                       [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

/// An event of a body that held.
inline BlowEvent noBreak() {
    return BlowEvent(plate(crumbly()));
}

/// Steps until something breaks; the event, or `noBreak()` if nothing does.
inline BlowEvent stepUntilBreak(TestWorld& scene, FractureWorld& fracture, int most_steps = 240,
                                double dt = 1.0 / 240) {
    for (int i = 0; i < most_steps; ++i) {
        scene.step(1, dt);
        for (BlowEvent& event : fracture.takeEvents())
            if (event.outcome != Outcome::held) return event;
    }
    return noBreak();
}

inline bool inWorld(const TestWorld& scene, const btCollisionObject* object) {
    const auto& objects = scene.world->getCollisionObjectArray();
    return objects.findLinearSearch(const_cast<btCollisionObject*>(object)) != objects.size();
}

}  // namespace sherd::bullet_tests
