// Stress problems that are made beside the steps, before a blow needs them.

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>
#include <vector>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// Waits for what other threads do, for a minute at most. Whether it has come true.
bool waitUntil(const std::function<bool()>& is_true) {
    const auto last = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!is_true() && std::chrono::steady_clock::now() < last)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return is_true();
}

/// An upright pane that is held on the left and on the right, and breaks into few pieces.
struct HeldPane {
    explicit HeldPane(int prepared_fragments) {
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        Budget budget;
        budget.prepared_fragments = prepared_fragments;
        EXPECT_TRUE(fracture.setBudget(budget).ok());
        Settings settings = Settings::forQuality(Quality::preview);
        settings.sampling.spacing_m = 0.04;
        settings.fracture.largest_fragment_count = 4;
        const auto asset =
            BreakableAsset::fromMesh(shapes::slab(Vec3(1.2, 0.01, 1.2)), Material::glass(), settings);
        EXPECT_TRUE(asset.ok()) << asset.error();
        BodyOptions options;
        options.supports = {BoxRegion{{-1, -1, -1}, {-0.55, 1, 1}}, BoxRegion{{0.55, -1, -1}, {1, 1, 1}}};
        EXPECT_TRUE(fracture.add(asset.value(), options).ok());
    }
    /// What is held stops a light one.
    void throwBall(btScalar x, btScalar z, double mass_kg = 0.1) {
        scene.addBall(mass_kg, 0.05, btVector3(x, -0.8f, z), btVector3(0, 15, 0));
        for (int i = 0; i < 60; ++i) {
            scene.step();
            for (BlowEvent& event : fracture.takeEvents())
                if (event.outcome == Outcome::broke) breaks.push_back(std::move(event));
        }
    }
    std::vector<const BreakableAsset*> factored() const {
        std::vector<const BreakableAsset*> found;
        for (const btRigidBody* body : fracture.bodies())
            if (fracture.asset(body)->unknownCount() > 0) found.push_back(fracture.asset(body));
        return found;
    }
    bool waitForFactors(std::size_t count) const {
        return waitUntil([&] { return factored().size() >= count; });
    }
    std::vector<btScalar> numbers() const {
        std::vector<btScalar> all;
        for (const btRigidBody* body : fracture.bodies())
            for (int axis = 0; axis < 3; ++axis) {
                all.push_back(body->getCenterOfMassPosition()[axis]);
                all.push_back(body->getAngularVelocity()[axis]);
            }
        return all;
    }

    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    std::vector<BlowEvent> breaks;
};

bool hasThreads() {
    return std::thread::hardware_concurrency() > 1;
}

TEST(SolversAhead, AreFactoredBeforeTheNextBlow) {
    if (!hasThreads()) GTEST_SKIP() << "one core";
    HeldPane pane(Budget().prepared_fragments);
    pane.throwBall(0.2f, 0.1f);
    ASSERT_EQ(pane.breaks.size(), 1u);
    ASSERT_TRUE(pane.waitForFactors(2));
    EXPECT_EQ(pane.fracture.counts().solved(), 1) << "no blow has needed these";
    pane.throwBall(0.4f, 0.1f, 2);
    ASSERT_GE(pane.breaks.size(), 2u);
    EXPECT_EQ(pane.breaks[1].ms.factor, 0);
    EXPECT_EQ(pane.breaks[1].ms.coarse, 0);
    EXPECT_GE(pane.fracture.counts().foreseen, 2);
}

TEST(SolversAhead, NoMoreThanTheBudgetHas) {
    if (!hasThreads()) GTEST_SKIP() << "one core";
    for (const std::size_t most : {0u, 1u}) {
        HeldPane pane(static_cast<int>(most));
        pane.throwBall(0.2f, 0.1f);
        ASSERT_EQ(pane.breaks.size(), 1u);
        EXPECT_TRUE(pane.waitForFactors(most));
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        ASSERT_EQ(pane.factored().size(), most);
        if (most == 0) continue;
        const auto largest_held = [&] {
            double mass = 0;
            for (const btRigidBody* body : pane.fracture.bodies())
                if (body->isStaticObject()) mass = std::max(mass, pane.fracture.asset(body)->mass());
            return mass;
        };
        EXPECT_EQ(pane.factored()[0]->mass(), largest_held());
    }
    HeldPane pane(0);
    Budget wrong;
    wrong.prepared_fragments = -1;
    EXPECT_FALSE(pane.fracture.setBudget(wrong).ok());
}

/// Whether the thread is done, has not begun, or there is none.
TEST(SolversAhead, WhatComesOfABlowIsTheSameWithAnyThreads) {
    std::vector<std::vector<btScalar>> numbers;
    const std::vector<Executor> executors = {nullptr, workerThreads(1), workerThreads(2),
                                             [](const std::function<void()>&) {}};
    for (const Executor& executor : executors) {
        HeldPane pane(Budget().prepared_fragments);
        pane.fracture.setExecutor(executor);
        for (const btScalar x : {0.2f, -0.4f, 0.4f}) pane.throwBall(x, 0.1f);
        EXPECT_GE(pane.breaks.size(), 3u);
        numbers.push_back(pane.numbers());
    }
    for (const auto& one : numbers) EXPECT_EQ(one, numbers[0]);
}

/// A ball that passes a plate on its way, and one that does not come near.
TEST(SolversAhead, WhatIsInTheWayIsFactoredBeforeItIsStruck) {
    if (!hasThreads()) GTEST_SKIP() << "one core";
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset near_by = plate(crumbly()), far_off = plate(crumbly());
    const btTransform upright(btQuaternion(btVector3(1, 0, 0), SIMD_HALF_PI), btVector3(0, 0, 0));
    ASSERT_TRUE(fracture.add(near_by, upright).ok());
    ASSERT_TRUE(fracture.add(far_off, at(3, 0, 0)).ok());
    scene.step(10);
    EXPECT_EQ(near_by.unknownCount(), 0) << "nothing moves yet";
    scene.addBall(1, 0.05, btVector3(0, -3, 0), btVector3(0, 6, 0));
    scene.step(2);
    EXPECT_TRUE(waitUntil([&] { return near_by.unknownCount() > 0; }));
    EXPECT_EQ(far_off.unknownCount(), 0);
    EXPECT_EQ(fracture.counts().seen, 0);
}

/// The thread may be at a fragment that the world no longer has, or at the last of one that is destroyed.
TEST(SolversAhead, MayGoAtAnyTime) {
    for (const bool remove : {true, false}) {
        HeldPane pane(Budget().prepared_fragments);
        pane.throwBall(0.2f, 0.1f);
        ASSERT_EQ(pane.breaks.size(), 1u);
        if (remove)
            for (btRigidBody* body : pane.fracture.bodies()) pane.fracture.remove(body);
    }
}

}  // namespace
