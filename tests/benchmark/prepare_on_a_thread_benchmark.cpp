// Whether steps wait while an asset is prepared on another thread: 240 steps of a world in which bodies of
// that asset tumble among boxes, with and without the worker. Usage: prepare_on_a_thread_benchmark [REPEATS]
//
// Waits are voluntary context switches of the stepping thread; unlike times they do not depend on what else
// the machine does.

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "support/shapes.h"

namespace {

using namespace sherd;

BreakableAsset plate() {
    return BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                    Material::plaster())
        .value();
}

long waitsOfThisThread() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nvcsw;
}

struct Steps {
    double longest_ms = 0, median_ms = 0;
    long waits = 0;
    int prepared = 0;  // assets that the worker got done meanwhile
};

/// Plates of the asset and boxes, dropped in a heap. The longest step is that of the first blow that is
/// solved.
Steps run(bool with_worker) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(btVector3(0, 0, -9.81f));
    btBoxShape slab(btVector3(10, 10, 0.5f)), brick(btVector3(0.1f, 0.1f, 0.1f));
    btRigidBody floor(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &slab));
    floor.translate(btVector3(0, 0, -0.5f));
    world.addRigidBody(&floor);
    std::vector<std::unique_ptr<btRigidBody>> bricks;
    btVector3 inertia;
    brick.calculateLocalInertia(1, inertia);
    for (int i = 0; i < 200; ++i) {
        bricks.push_back(std::make_unique<btRigidBody>(1, nullptr, &brick, inertia));
        bricks.back()->translate(btVector3(0.25f * (i % 5), 0.25f * (i / 5 % 5), 0.12f + 0.21f * (i / 25)));
        world.addRigidBody(bricks.back().get());
    }

    const BreakableAsset asset = plate();
    FractureWorld fracture(&world);
    for (int i = 0; i < 8; ++i)
        (void)fracture.add(asset,
                           btTransform(btQuaternion::getIdentity(), btVector3(2, 0, 0.0305f + 0.0605f * i)));

    std::atomic<bool> over{false};
    int prepared = 0;
    std::thread worker;
    if (with_worker)
        worker = std::thread([&] {
            for (BreakableAsset next = asset; !over; next = plate(), ++prepared)
                if (!next.prepareOnThread().get()) std::abort();
        });

    Steps steps;
    std::vector<double> ms;
    const long waits_before = waitsOfThisThread();
    for (int i = 0; i < 240; ++i) {
        const auto start = std::chrono::steady_clock::now();
        world.stepSimulation(1.0f / 240, 0);
        ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    steps.waits = waitsOfThisThread() - waits_before;
    over = true;
    if (worker.joinable()) worker.join();
    steps.prepared = prepared;
    if (fracture.counts().solved() > 0) std::printf("(%lld blows were solved)\n", fracture.counts().solved());
    steps.longest_ms = *std::max_element(ms.begin(), ms.end());
    std::nth_element(ms.begin(), ms.begin() + ms.size() / 2, ms.end());
    steps.median_ms = ms[ms.size() / 2];
    for (const auto& body : bricks) world.removeRigidBody(body.get());
    world.removeRigidBody(&floor);
    return steps;
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 9;
    std::vector<double> longest[2], medians[2];
    for (int repeat = 0; repeat < repeats; ++repeat)
        for (const bool with_worker : {false, true}) {
            const Steps steps = run(with_worker);
            std::printf("%-14s longest step %6.2f ms, median %5.2f ms, %ld waits, %d assets prepared\n",
                        with_worker ? "with worker" : "without", steps.longest_ms, steps.median_ms,
                        steps.waits, steps.prepared);
            longest[with_worker].push_back(steps.longest_ms);
            medians[with_worker].push_back(steps.median_ms);
        }
    const auto least = [](const std::vector<double>& values) {
        return *std::min_element(values.begin(), values.end());
    };
    std::printf(
        "best of %d runs: longest step %.2f ms without, %.2f ms with worker (%+.0f %%); median %.2f, %.2f "
        "ms\n",
        repeats, least(longest[0]), least(longest[1]), 100 * (least(longest[1]) / least(longest[0]) - 1),
        least(medians[0]), least(medians[1]));
}
