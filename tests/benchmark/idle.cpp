// What breakable bodies cost that nothing happens to, and what a heap of them costs under a weight.
//
//   idle [CUPS]      200 stoneware cups stand on a floor: a step beside that of the same shapes in a world
//                    without Sherd, awake and asleep, and the memory that a body adds
//   idle plates [N [paced]]
//                    40 plates of stoneware lie on each other, and a block of 500 kg falls on them from 1 cm:
//                    26 steps at 60 Hz, with the budget of the defaults; paced: after each step it waits for
//                    the time that it simulates, as a game does

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "benchmark/floor_world.h"
#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "core/numerics/stopwatch.h"
#include "support/resident_memory.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

constexpr btScalar time_step_s = btScalar(1) / 60;

double stepMilliseconds(btDiscreteDynamicsWorld& world) {
    const Stopwatch watch;
    world.stepSimulation(time_step_s, 0);
    return watch.milliseconds();
}

void setAwake(const btDiscreteDynamicsWorld& world, bool awake) {
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (!objects[i]->isStaticObject())
            objects[i]->forceActivationState(awake ? DISABLE_DEACTIVATION : ISLAND_SLEEPING);
}

/// Bodies like those of another world, with the same shapes.
struct PlainCopies {
    PlainCopies(const btDiscreteDynamicsWorld& from, btDiscreteDynamicsWorld& into) : world(into) {
        const auto& objects = from.getCollisionObjectArray();
        for (int i = 0; i < objects.size(); ++i) {
            btRigidBody* original = btRigidBody::upcast(objects[i]);
            if (!original || original->isStaticObject()) continue;
            bodies.push_back(std::make_unique<btRigidBody>(1 / original->getInvMass(), nullptr,
                                                           original->getCollisionShape(),
                                                           original->getLocalInertia()));
            bodies.back()->setWorldTransform(original->getWorldTransform());
            bodies.back()->setFriction(original->getFriction());
            bodies.back()->setRestitution(original->getRestitution());
            into.addRigidBody(bodies.back().get());
        }
    }
    ~PlainCopies() {
        for (const auto& body : bodies) world.removeRigidBody(body.get());
    }
    btDiscreteDynamicsWorld& world;
    std::vector<std::unique_ptr<btRigidBody>> bodies;
};

void standCups(int count) {
    const BreakableAsset cup =
        valueOrExit(BreakableAsset::fromObj(SHERD_ASSETS "/coffee_cup.obj", Material::ceramic()));
    succeedOrExit(cup.prepare());
    FloorWorld with, without;
    FractureWorld fracture(&with.world);
    const auto place = [&](int i) {
        return btTransform(btQuaternion::getIdentity(), btVector3(btScalar(0.13) * btScalar(i % 20),
                                                                  btScalar(0.13) * btScalar(i / 20), 0));
    };
    valueOrExit(fracture.add(cup, place(0)));  // makes the shape
    const double before = residentBytes();
    for (int i = 1; i < count; ++i) valueOrExit(fracture.add(cup, place(i)));
    std::printf("%d cups: %.2f kB a body\n", count, (residentBytes() - before) / 1e3 / (count - 1));
    const PlainCopies copies(with.world, without.world);
    for (const bool awake : {true, false}) {
        setAwake(with.world, true);
        setAwake(without.world, true);
        for (int i = 0; i < 240; ++i) {  // they come to rest
            stepMilliseconds(with.world);
            stepMilliseconds(without.world);
        }
        setAwake(with.world, awake);
        setAwake(without.world, awake);
        std::vector<double> own, plain;
        for (int i = 0; i < 600; ++i) {
            const bool own_first = i % 2 == 0;  // the second one finds the shapes in the cache
            if (own_first) own.push_back(stepMilliseconds(with.world));
            plain.push_back(stepMilliseconds(without.world));
            if (!own_first) own.push_back(stepMilliseconds(with.world));
        }
        std::printf("%s: step %.4f ms, plain Bullet %.4f ms: %.3f\n", awake ? "awake" : "asleep", median(own),
                    median(plain), median(own) / median(plain));
    }
    std::printf("%lld blows seen\n", fracture.counts().seen);
}

void pressPlates(int count, bool paced) {
    const BreakableAsset plate = valueOrExit(
        BreakableAsset::fromMesh(shapes::slab(Vec3(0.3, 0.3, 0.01), 12, 12, 1), Material::ceramic()));
    succeedOrExit(plate.prepare());
    FloorWorld room;
    FractureWorld fracture(&room.world);
    for (int i = 0; i < count; ++i)
        valueOrExit(fracture.add(
            plate, btTransform(btQuaternion::getIdentity(), btVector3(0, 0, btScalar(0.005 + 0.0101 * i)))));
    btBoxShape cube(btVector3(btScalar(0.2), btScalar(0.2), btScalar(0.2)));
    btVector3 inertia;
    cube.calculateLocalInertia(500, inertia);
    btRigidBody block(500, nullptr, &cube, inertia);
    block.translate(btVector3(0, 0, btScalar(0.0101 * count + 0.21)));
    room.world.addRigidBody(&block);
    std::vector<double> steps;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 26; ++i) {
        steps.push_back(stepMilliseconds(room.world));
        fracture.takeEvents();
        if (paced)
            std::this_thread::sleep_until(start + std::chrono::duration<double>((i + 1) * time_step_s));
    }
    const BlowCounts counts = fracture.counts();
    std::printf(
        "%d plates: step median %.1f ms, longest %.1f ms; %lld blows, %lld solved, %lld waited, %lld "
        "dropped; %zu bodies\n",
        count, median(steps), quantile(steps, 1), counts.seen, counts.solved(), counts.waited, counts.dropped,
        fracture.bodies().size());
    room.world.removeRigidBody(&block);
}

}  // namespace

int main(int count, char** arguments) {
    const std::string first = count > 1 ? arguments[1] : "";
    if (first == "plates")
        pressPlates(count > 2 ? std::atoi(arguments[2]) : 40, count > 3);
    else
        standCups(first.empty() ? 200 : std::atoi(first.c_str()));
    return 0;
}
