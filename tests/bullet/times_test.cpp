// What a FractureWorld takes, by its own timers. Nothing here depends on how fast the machine is.

#include <algorithm>

#include "bullet/support.h"
#include "core/numerics/stopwatch.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A plate whose pieces break in their turn, and whose weak blows are solved for their events.
BreakableAsset checkedPlate() {
    Settings settings = coarse(0.06);
    settings.fracture.fragment_count = 4;
    settings.fracture.smallest_fragment_m3 = 1e-6;
    settings.fracture.rest_after_break_s = settings.fracture.same_blow_s = 0;
    settings.fracture.check_with_full_solve = true;
    settings.fracture.collision_shape = CollisionShape::hull;  // which overlap at birth
    return BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)), crumbly(),
                                    settings)
        .value();
}

/// Pushes the middle of a body.
void pushMiddle(FractureWorld& fracture, btRigidBody* body, float impulse_n_s) {
    const Status done = fracture.applyBlow(
        body, {body->getCenterOfMassPosition() + btVector3(0, 0, 0.03f), btVector3(0, 0, -impulse_n_s)});
    EXPECT_TRUE(done.ok()) << done.error();
}

template <class Times>
void expectAllMeasured(const Times& times) {
    for (const TimeField<Times>& field : time_fields<Times>) EXPECT_GT(times.*field.value, 0) << field.name;
}

TEST(Times, EveryStageHasATimer) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Budget nothing_ahead;
    nothing_ahead.foresight_s = 0;
    ASSERT_TRUE(fracture.setBudget(nothing_ahead).ok());
    ASSERT_TRUE(fracture.add(checkedPlate(), at(0, 0, 0)).ok());
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    const BlowEvent first = stepUntilBreak(scene, fracture);
    ASSERT_EQ(first.outcome, Outcome::broke) << first.message;
    EXPECT_EQ(first.ms.sample, 0) << "a body is sampled when it is added";
    EXPECT_GT(first.ms.factor, 0) << "nobody has prepared it";
    ASSERT_TRUE(fracture.setBudget({}).ok());

    const auto whole = fracture.bodies();
    pushMiddle(fracture, whole.front(), 50);
    pushMiddle(fracture, whole.back(), 1e-9f);
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 2u);
    EXPECT_GT(events[0].ms.sample, 0) << "a fragment is sampled when it is struck";
    EXPECT_GT(events[1].ms.check, 0);
    expectAllMeasured(fracture.times().blows);

    // Pieces on their way down, struck by what does not give way: blows that wait.
    scene.addBox(0, btVector3(5, 5, 0.5f), btVector3(0, 0, -1));
    for (btRigidBody* body : fracture.bodies()) body->setLinearVelocity(btVector3(0, 0, -8));
    scene.step(40);
    expectAllMeasured(fracture.times().steps);
}

TEST(Times, StagesAddUpToTheWholeAndTheWholeIsPartOfTheStep) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    BodyOptions options(at(0, 0, 0.2f));
    // Shapes of hollow bodies take long to make.
    const auto made = BreakableAsset::fromMesh(shapes::cup(0.2, 0.3, 0.04, 24, 4), crumbly(), coarse(0.04));
    ASSERT_TRUE(made.ok()) << made.error();
    const BreakableAsset& asset = made.value();
    options.fracture = asset.settings().fracture;
    options.fracture->collision_shape = CollisionShape::convex_parts;
    ASSERT_TRUE(fracture.add(asset, options).ok());
    bool broke = false;
    for (int i = 0; i < 120; ++i) {
        const WorldTimes before = fracture.times();
        const Stopwatch watch;
        scene.step();
        const double step_ms = watch.milliseconds();
        const WorldTimes after = fracture.times();
        const double stages_ms = after.stages() - before.stages(), whole_ms = after.whole - before.whole;
        EXPECT_LE(stages_ms, whole_ms) << "something is counted twice";
        EXPECT_LE(whole_ms + after.bullet_solve - before.bullet_solve, step_ms);
        double blows_ms = 0;
        for (const BlowEvent& event : fracture.takeEvents()) {
            blows_ms += event.ms.total() - event.ms_elsewhere.total();
            if (event.outcome != Outcome::broke) continue;
            broke = true;
            EXPECT_GT(event.ms.bodies, after.steps.resolve - before.steps.resolve);
        }
        EXPECT_LE(blows_ms, stages_ms + 1e-6);
    }
    EXPECT_TRUE(broke);
    // Everything large has a timer. A scene's report shows how close the sum really is.
    EXPECT_GT(fracture.times().stages(), 0.8 * fracture.times().whole);
    EXPECT_GT(fracture.times().bullet_solve, 0);
}

TEST(Times, OfAllBlowsAreThoseOfTheirEventsAndTheGateOfTheOthers) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(Material::plaster()), at(0, 0, 0)).value();
    pushMiddle(fracture, body, 1e-6f);
    ASSERT_TRUE(fracture.takeEvents().empty());
    const StageTimes silent = fracture.times().blows;
    EXPECT_GT(silent.gate, 0);
    EXPECT_EQ(silent.total(), silent.gate);

    pushMiddle(fracture, body, 1000);
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    ASSERT_EQ(events[0].outcome, Outcome::broke) << events[0].message;
    for (const auto& field : time_fields<StageTimes>)
        EXPECT_EQ(fracture.times().blows.*field.value, silent.*field.value + events[0].ms.*field.value)
            << field.name;
}

TEST(Times, ABlowOnAPreparedBodyTakesNoFactor) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset asset = plate(Material::plaster());
    ASSERT_TRUE(asset.prepare().ok());
    pushMiddle(fracture, fracture.add(asset, at(0, 0, 0)).value(), 1000);
    const StageTimes ms = fracture.takeEvents().at(0).ms;
    EXPECT_EQ(ms.sample + ms.assemble + ms.factor, 0);
    EXPECT_GT(ms.loads, 0);
}

TEST(Times, WhatAnAppsCallbackDoesCountsAsSwap) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    double callback_ms = 0;
    fracture.onFragment([&](FragmentBirth&) {
        const Stopwatch watch;
        while (watch.milliseconds() < 1) continue;
        callback_ms += watch.milliseconds();
    });
    pushMiddle(fracture, fracture.add(plate(crumbly()), at(0, 0, 0)).value(), 50);
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.at(0).outcome, Outcome::broke);
    EXPECT_GT(callback_ms, 0);
    EXPECT_GE(events[0].ms.swap, callback_ms);
    EXPECT_GE(fracture.times().whole, fracture.times().stages());
}

}  // namespace
