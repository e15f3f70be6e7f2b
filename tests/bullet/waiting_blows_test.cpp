#include "bullet/schedule/waiting_blows.h"

#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include <utility>
#include <vector>

namespace sherd {
namespace {

WaitingBlow blowOn(std::uint64_t serial) {
    WaitingBlow blow;
    blow.serial = serial;
    blow.energy_j = 1;
    return blow;
}

constexpr double step_s = 1.0 / 60, ages_ms = 1e5;

WaitingBlows::Fate add(WaitingBlows& waiting, WaitingBlow blow, double work_ms, const Budget& budget,
                       double time_s) {
    return waiting.add(std::move(blow), WaitingBlows::turn_s(work_ms, budget, step_s), budget, time_s);
}

TEST(WaitingBlows, NoneWaitsForLongerThanTheBudgetSays) {
    const Budget budget;
    WaitingBlows waiting;
    ASSERT_EQ(add(waiting, blowOn(1), ages_ms, budget, 2), WaitingBlows::Fate::waits);
    EXPECT_EQ(waiting.due(2 + budget.longest_wait_s - step_s), nullptr);
    EXPECT_NE(waiting.due(2 + budget.longest_wait_s), nullptr);
    // The worker is as busy as if it did all of it.
    EXPECT_EQ(add(waiting, blowOn(2), 1, budget, 2), WaitingBlows::Fate::dropped);
}

TEST(WaitingBlows, ASmallOneIsDueAfterTheShortestWait) {
    const Budget budget;
    WaitingBlows waiting;
    ASSERT_EQ(add(waiting, blowOn(1), 0.1, budget, 2), WaitingBlows::Fate::waits);
    EXPECT_EQ(waiting.due(2 + budget.shortest_wait_s - 1e-3), nullptr);
    EXPECT_NE(waiting.due(2 + budget.shortest_wait_s), nullptr);
}

TEST(WaitingBlows, AHarderBlowTakesThePlaceOfOneThatIsNotBegun) {
    const Budget budget;
    WaitingBlows waiting;
    constexpr double work_ms = 200;  // of which the budget does 1000 a second
    for (const int body : {1, 2})
        ASSERT_EQ(add(waiting, blowOn(body), work_ms, budget, 2), WaitingBlows::Fate::waits);
    WaitingBlow harder = blowOn(2);
    harder.energy_j = 5;
    harder.position = Vec3::UnitX();
    EXPECT_EQ(add(waiting, harder, work_ms, budget, 2 + step_s), WaitingBlows::Fate::merged);
    EXPECT_EQ(add(waiting, blowOn(2), work_ms, budget, 2 + step_s), WaitingBlows::Fate::merged);
    ASSERT_EQ(waiting.takeFirst().serial, 1);
    const WaitingBlow second = waiting.takeFirst();
    EXPECT_EQ(second.energy_j, 5);
    EXPECT_EQ(second.position, Vec3::UnitX());
    EXPECT_EQ(second.struck_at_s, 2 + step_s);
    EXPECT_NEAR(second.due_s, 2 + 0.4, 1e-9) << "the turn of the first";
    EXPECT_TRUE(waiting.empty());
}

TEST(WaitingBlows, AnotherBudgetHoldsForWhatWaits) {
    Budget patient;
    patient.shortest_wait_s = 5;
    patient.longest_wait_s = 6;
    WaitingBlows waiting;
    add(waiting, blowOn(1), ages_ms, patient, 2);
    const Budget usual;
    waiting.keepTo(usual, 3);
    EXPECT_NE(waiting.due(3), nullptr);
    ASSERT_EQ(add(waiting, blowOn(2), 1, usual, 3.5), WaitingBlows::Fate::waits);
    waiting.takeFirst();
    EXPECT_NE(waiting.due(3.5 + usual.longest_wait_s), nullptr);
}

TEST(WaitingBlows, WhereNoneMayWaitAnyMoreAllAreDue) {
    const Budget usual;
    WaitingBlows waiting;
    for (const int body : {1, 2}) add(waiting, blowOn(body), 100, usual, 2);
    waiting.keepTo(Budget::none(), 2.01);
    for (const std::uint64_t body : {1, 2}) {
        ASSERT_NE(waiting.due(2.01), nullptr) << body;
        EXPECT_EQ(waiting.takeFirst().serial, body);
    }
}

TEST(WaitingBlows, WholeBodiesGoBeforeFragments) {
    const Budget budget;
    WaitingBlows waiting;
    constexpr double work_ms = 100;  // a tenth of a second
    for (const int body : {1, 2, 3}) add(waiting, blowOn(body), work_ms, budget, 2);
    for (const int body : {4, 5}) {
        WaitingBlow whole = blowOn(body);
        whole.is_on_fragment = false;
        ASSERT_EQ(add(waiting, whole, work_ms / 5, budget, 2), WaitingBlows::Fate::waits);
    }
    std::vector<std::uint64_t> order;
    std::vector<double> due_s;
    while (!waiting.empty()) {
        const WaitingBlow blow = waiting.takeFirst();
        order.push_back(blow.serial);
        due_s.push_back(blow.due_s - 2);
    }
    EXPECT_EQ(order, (std::vector<std::uint64_t>{1, 2, 4, 5, 3})) << "the first two are begun, or nearly so";
    const std::vector<double> expected{0.1, 0.2, 0.22, 0.24, 0.34};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(due_s[i], expected[i], 1e-9);
}

TEST(WaitingBlows, WholeBodiesHaveTheTimeOfFragmentsAndHalfOfTheLongestWaitAtLeast) {
    const Budget budget;
    WaitingBlows waiting;
    for (const int body : {1, 2}) add(waiting, blowOn(body), 200, budget, 2);
    EXPECT_NEAR(waiting.left_s(budget, 2), 0.3, 1e-9) << "the second fragment is overtaken";
    WaitingBlow kept = blowOn(3);
    kept.is_on_fragment = false;
    kept.is_kept = true;
    ASSERT_EQ(waiting.add(kept, 0.3, budget, 2), WaitingBlows::Fate::waits);
    EXPECT_NEAR(waiting.left_s(budget, 2), budget.longest_wait_s / 2, 1e-9);
}

/// What an explosion does is not lost because something else strikes the body harder, or first.
TEST(WaitingBlows, ABodyOfAnExplosionIsKeptWhateverElseStrikesIt) {
    const Budget budget;
    for (const bool is_first : {true, false}) {
        WaitingBlows waiting;
        WaitingBlow of_explosion = blowOn(1), ordinary = blowOn(1);
        for (const std::uint64_t body : {10, 11}) add(waiting, blowOn(body), 180, budget, 2);
        of_explosion.is_kept = true;
        of_explosion.promised = 5;
        ordinary.promised = 8;
        ordinary.energy_j = 5;  // the harder one
        ASSERT_EQ(add(waiting, is_first ? of_explosion : ordinary, 50, budget, 2), WaitingBlows::Fate::waits);
        EXPECT_EQ(waiting.promised(), is_first ? 5 : 0);
        ASSERT_EQ(add(waiting, is_first ? ordinary : of_explosion, 50, budget, 2),
                  WaitingBlows::Fate::merged);
        EXPECT_EQ(waiting.promised(), 8) << is_first;
        EXPECT_NE(waiting.keptFor(1), nullptr) << is_first;
    }
}

TEST(WaitingBlows, OneThatIsBegunIsAnswered) {
    const Budget budget;
    WaitingBlows waiting;
    ASSERT_EQ(add(waiting, blowOn(1), 50, budget, 2), WaitingBlows::Fate::waits);
    WaitingBlow harder = blowOn(1);
    harder.energy_j = 5;
    EXPECT_EQ(add(waiting, harder, 50, budget, 2), WaitingBlows::Fate::waits);
    EXPECT_EQ(waiting.takeFirst().energy_j, 1);
    EXPECT_EQ(waiting.takeFirst().energy_j, 5);
}

TEST(WaitingBlows, WhatAStepDecidesTakesTheWorkerFromThem) {
    const Budget budget;
    WaitingBlows waiting;
    constexpr double work_ms = 100, until_s = 0.5;
    for (const int body : {1, 2}) add(waiting, blowOn(body), work_ms, budget, 2);
    waiting.interrupt(0.01, budget, 2.05);  // in the midst of the first
    add(waiting, blowOn(3), work_ms, budget, 2.05);
    for (const double due_s : {0.11, 0.21, 0.31}) EXPECT_NEAR(waiting.takeFirst().due_s - 2, due_s, 1e-9);
    add(waiting, blowOn(4), work_ms, budget, 3);
    waiting.interrupt(ages_ms, budget, 3.01);
    EXPECT_NEAR(waiting.takeFirst().due_s - 3, until_s, 1e-9) << "none waits for longer";
}

/// A pane thinner than a spacing has particles side by side, not a part of one in its thickness.
TEST(WaitingBlows, TheEstimateKnowsThinWalls) {
    constexpr double spacing_m = 0.04;
    const auto estimate = [&](double thickness_m) {
        Settings settings;
        settings.sampling.spacing_m = spacing_m;
        const auto asset =
            BreakableAsset::fromMesh(boxMesh(Vec3(0.8, thickness_m, 0.8)), Material::glass(), settings);
        EXPECT_TRUE(asset.ok()) << asset.error();
        EXPECT_NEAR(asset.value().particleCount(), 400, 100) << thickness_m << " m thick";
        return estimatedMilliseconds(*asset.value().solid(), {});
    };
    EXPECT_NEAR(estimate(0.005), estimate(spacing_m), 1e-6 * estimate(spacing_m));
}

}  // namespace
}  // namespace sherd
