// Worlds that are stepped on threads of their own, and assets that other threads make meanwhile.

#include <atomic>
#include <thread>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A plate that a ball breaks and its pieces, after half a second.
struct PlateRun {
    explicit PlateRun(const BreakableAsset& asset) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        for (int i = 0; i < 2; ++i)
            EXPECT_TRUE(fracture.add(asset, at(0, 0, 0.3f + 0.5f * btScalar(i))).ok());
        scene.addBall(2, 0.1, btVector3(0.05f, 0, 1.2f), btVector3(0, 0, -8));
        for (int i = 0; i < 120; ++i) {
            scene.step();
            for (BlowEvent& event : fracture.takeEvents())
                if (event.outcome == Outcome::broke) breaks.push_back(std::move(event));
        }
        for (const btRigidBody* body : fracture.bodies())
            for (int axis = 0; axis < 3; ++axis) {
                numbers.push_back(body->getCenterOfMassPosition()[axis]);
                numbers.push_back(body->getAngularVelocity()[axis]);
            }
    }
    std::vector<BlowEvent> breaks;
    std::vector<btScalar> numbers;
};

TEST(Threads, WorldsOnThreadsOfTheirOwnShareAnAsset) {
    const PlateRun alone(plate(crumbly()));
    ASSERT_EQ(alone.breaks.size(), 2u);
    const BreakableAsset shared = plate(crumbly());  // sampled and factored by whichever thread is first
    std::vector<std::unique_ptr<PlateRun>> runs(3);
    std::vector<std::thread> threads;
    for (auto& run : runs) threads.emplace_back([&] { run = std::make_unique<PlateRun>(shared); });
    for (std::thread& thread : threads) thread.join();
    for (const auto& run : runs) EXPECT_EQ(run->numbers, alone.numbers);
}

TEST(Threads, AssetsAreMadeAndEventsReadOnAnotherThreadWhileAWorldIsStepped) {
    const PlateRun alone(plate(crumbly()));
    std::atomic<bool> stepped{false};
    int made = 0;
    std::thread worker([&] {
        do {
            const BreakableAsset other = plate(unbreakable());
            EXPECT_TRUE(other.prepare().ok());
            ++made;
        } while (!stepped);
    });
    PlateRun run(plate(crumbly()));
    stepped = true;
    worker.join();
    EXPECT_GT(made, 0);
    EXPECT_EQ(run.numbers, alone.numbers);

    // The world and its bodies are gone; what an event holds by value goes to any thread.
    std::thread reader([events = std::move(run.breaks)] {
        for (const BlowEvent& event : events) {
            EXPECT_EQ(event.asset.surface().vertices.size(), 8u);
            EXPECT_GT(event.asset.mass(), 0);
            EXPECT_GT(event.impulse_n_s, 0);
        }
    });
    reader.join();
}

}  // namespace
