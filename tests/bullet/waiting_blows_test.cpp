#include "bullet/waiting_blows.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

WaitingBlow blowOn(std::uint64_t serial) {
    WaitingBlow blow;
    blow.serial = serial;
    blow.impulse_n_s = 1;
    return blow;
}

constexpr double step_s = 1.0 / 60, ages_ms = 1e5;

TEST(WaitingBlows, NoneWaitsForLongerThanTheBudgetSays) {
    const Budget budget;
    WaitingBlows waiting;
    ASSERT_EQ(waiting.add(blowOn(1), ages_ms, budget, 2, step_s), WaitingBlows::Fate::waits);
    EXPECT_EQ(waiting.due(2 + budget.longest_wait_s - step_s), nullptr);
    EXPECT_NE(waiting.due(2 + budget.longest_wait_s), nullptr);
    // The worker is as busy as if it did all of it.
    EXPECT_EQ(waiting.add(blowOn(2), 1, budget, 2, step_s), WaitingBlows::Fate::dropped);
}

TEST(WaitingBlows, ASmallOneIsDueAfterTheShortestWait) {
    const Budget budget;
    WaitingBlows waiting;
    ASSERT_EQ(waiting.add(blowOn(1), 0.1, budget, 2, step_s), WaitingBlows::Fate::waits);
    EXPECT_EQ(waiting.due(2 + budget.shortest_wait_s - 1e-3), nullptr);
    EXPECT_NE(waiting.due(2 + budget.shortest_wait_s), nullptr);
}

TEST(WaitingBlows, AHarderBlowTakesThePlaceOfOneThatIsNotBegun) {
    const Budget budget;
    WaitingBlows waiting;
    constexpr double work_ms = 100;  // of which the budget does 500 a second
    for (const int body : {1, 2})
        ASSERT_EQ(waiting.add(blowOn(body), work_ms, budget, 2, step_s), WaitingBlows::Fate::waits);
    WaitingBlow harder = blowOn(2);
    harder.impulse_n_s = 5;
    harder.position = Vec3::UnitX();
    EXPECT_EQ(waiting.add(harder, work_ms, budget, 2 + step_s, step_s), WaitingBlows::Fate::merged);
    EXPECT_EQ(waiting.add(blowOn(2), work_ms, budget, 2 + step_s, step_s), WaitingBlows::Fate::merged);
    ASSERT_EQ(waiting.takeFirst().serial, 1);
    const WaitingBlow second = waiting.takeFirst();
    EXPECT_EQ(second.impulse_n_s, 5);
    EXPECT_EQ(second.position, Vec3::UnitX());
    EXPECT_EQ(second.struck_at_s, 2 + step_s);
    EXPECT_NEAR(second.due_s, 2 + 0.4, 1e-9) << "the turn of the first";
    EXPECT_TRUE(waiting.empty());
}

TEST(WaitingBlows, OneThatIsBegunIsAnswered) {
    const Budget budget;
    WaitingBlows waiting;
    ASSERT_EQ(waiting.add(blowOn(1), 50, budget, 2, step_s), WaitingBlows::Fate::waits);
    WaitingBlow harder = blowOn(1);
    harder.impulse_n_s = 5;
    EXPECT_EQ(waiting.add(harder, 50, budget, 2, step_s), WaitingBlows::Fate::waits);
    EXPECT_EQ(waiting.takeFirst().impulse_n_s, 1);
    EXPECT_EQ(waiting.takeFirst().impulse_n_s, 5);
}

}  // namespace
}  // namespace sherd
