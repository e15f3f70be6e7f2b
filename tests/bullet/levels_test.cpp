// Which level decided a blow, and what a full solve says of those that it did not decide.

#include <algorithm>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// What a plate that stands on the floor goes through, with a light ball and a heavy one.
struct Struck {
    explicit Struck(bool check) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        BodyOptions options(
            btTransform(btQuaternion(btVector3(1, 0, 0), SIMD_HALF_PI), btVector3(0, 0, 0.301f)));
        const BreakableAsset asset = plate(Material::plaster());
        options.fracture = asset.settings().fracture;
        options.fracture->check_with_full_solve = check;
        EXPECT_TRUE(fracture.add(asset, options).ok());
        scene.addBall(1, 0.1, btVector3(0, 0.14f, 0.4f), btVector3(0, -1.5f, 0));
        scene.addBall(5, 0.1, btVector3(0, -1, 0.4f), btVector3(0, 8, 0));
        for (int i = 0; i < 60; ++i) {
            scene.step();
            for (BlowEvent& event : fracture.takeEvents()) events.push_back(std::move(event));
            for (const btRigidBody* body : fracture.bodies()) places.push_back(body->getWorldTransform());
        }
        counts = fracture.counts();
    }
    int eventsBy(Level level) const {
        return static_cast<int>(std::count_if(events.begin(), events.end(),
                                              [&](const BlowEvent& event) { return event.level == level; }));
    }

    std::vector<BlowEvent> events;
    std::vector<btTransform> places;  // of all bodies after each step
    BlowCounts counts;
};

TEST(Levels, EveryBlowIsCountedOnceByTheLevelThatDecidedIt) {
    const Struck run(false);
    EXPECT_GT(run.counts.gate, 0);
    EXPECT_GT(run.counts.full, 0);
    EXPECT_EQ(run.counts.seen, run.counts.gate + run.counts.coarse + run.counts.reduced + run.counts.full);
    EXPECT_EQ(run.eventsBy(Level::gate), 0) << "nothing to say of them";
    EXPECT_EQ(run.eventsBy(Level::full), run.counts.full);
    for (const BlowEvent& event : run.events) EXPECT_FALSE(event.full_solve_outcome);
}

TEST(Levels, CheckedBlowsHaveAnEventWithWhatAFullSolveSaysOfThem) {
    const Struck run(true);
    ASSERT_EQ(run.events.size(), static_cast<std::size_t>(run.counts.seen));
    double largest_pa = 0;  // none where bodies only rest on each other
    for (const BlowEvent& event : run.events) {
        EXPECT_EQ(event.full_solve_outcome.has_value(), event.level != Level::full);
        if (event.level != Level::gate) continue;
        EXPECT_EQ(event.full_solve_outcome, Outcome::held) << "skipped, and it would have broken";
        largest_pa = std::max(largest_pa, event.full_solve_largest_stress_pa);
        EXPECT_EQ(event.outcome, Outcome::held);
        EXPECT_EQ(event.largest_stress_pa, 0) << "nothing was solved to decide it";
        EXPECT_TRUE(event.fragments.empty());
    }
    EXPECT_GT(largest_pa, 0);
}

TEST(Levels, CheckingChangesNothingInTheWorld) {
    const Struck run(false), checked(true);
    EXPECT_TRUE(std::any_of(run.events.begin(), run.events.end(),
                            [](const BlowEvent& event) { return event.outcome == Outcome::broke; }));
    EXPECT_LT(run.counts.gate, checked.counts.gate)
        << "each contact is checked, also those of bodies at rest";
    EXPECT_EQ(run.counts.full, checked.counts.full);
    ASSERT_EQ(run.places.size(), checked.places.size());
    for (std::size_t i = 0; i < run.places.size(); ++i) {
        ASSERT_TRUE(sameBits(run.places[i].getOrigin(), checked.places[i].getOrigin())) << i;
        for (int row = 0; row < 3; ++row)
            ASSERT_TRUE(sameBits(run.places[i].getBasis()[row], checked.places[i].getBasis()[row])) << i;
    }
}

}  // namespace
