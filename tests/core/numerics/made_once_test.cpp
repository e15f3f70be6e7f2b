#include "core/numerics/made_once.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using namespace sherd;

TEST(MadeOnce, IsMadeByTheFirstWhoNeedsIt) {
    MadeOnce<int> value;
    EXPECT_EQ(value.ifMade(), nullptr);
    EXPECT_EQ(value.get([] { return 3; }), 3);
    EXPECT_EQ(value.get([] { return 4; }), 3);
    ASSERT_NE(value.ifMade(), nullptr);
    EXPECT_EQ(*value.ifMade(), 3);
}

TEST(MadeOnce, WhatCouldNotBeMadeIsTriedAgain) {
    MadeOnce<int> value;
    EXPECT_THROW(value.get([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
    EXPECT_EQ(value.ifMade(), nullptr);
    EXPECT_EQ(value.get([] { return 4; }), 4);
}

TEST(MadeOnce, WhoOnlyAsksDoesNotWaitForWhoMakes) {
    MadeOnce<int> value;
    std::promise<void> making, asked;
    std::thread maker([&] {
        value.get([&] {
            making.set_value();
            asked.get_future().wait();
            return 5;
        });
    });
    making.get_future().wait();
    EXPECT_EQ(value.ifMade(), nullptr);  // with a lock this would hang
    asked.set_value();
    maker.join();
    EXPECT_EQ(*value.ifMade(), 5);
}

TEST(MadeOnce, ManyThreadsGetTheSameOne) {
    MadeOnce<std::vector<int>> value;
    std::atomic<int> made{0};
    std::vector<const std::vector<int>*> seen(8);
    std::vector<std::thread> threads;
    for (auto& mine : seen)
        threads.emplace_back([&] {
            mine = &value.get([&] {
                ++made;
                return std::vector<int>(1000, 7);
            });
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(made, 1);
    for (const auto* mine : seen) EXPECT_EQ(mine, seen.front());
}

}  // namespace
