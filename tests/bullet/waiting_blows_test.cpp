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

}  // namespace
}  // namespace sherd
