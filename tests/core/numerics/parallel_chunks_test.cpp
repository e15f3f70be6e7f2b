#include "core/numerics/parallel_chunks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace sherd {
namespace {

TEST(ParallelChunks, EveryChunkOnceAndExceptionsCome) {
    std::vector<std::atomic<int>> runs(100);
    forEachChunk(100, [&](int chunk) { ++runs[chunk]; });
    for (const auto& count : runs) EXPECT_EQ(count, 1);
    EXPECT_THROW(forEachChunk(8,
                              [](int chunk) {
                                  if (chunk == 5) throw std::runtime_error("chunk");
                              }),
                 std::runtime_error);
    EXPECT_EQ(chunkBegin(0, 7, 100), 0);
    EXPECT_EQ(chunkBegin(7, 7, 100), 100);
}

// Helpers are there for all threads of a program, which may round in different ways.
TEST(ParallelChunks, HelpersRoundAsTheThreadThatAsks) {
    constexpr int count = 64;
    std::vector<int> modes(count);
    const auto ask = [&] {
        forEachChunk(count, [&](int chunk) {
            modes[chunk] = std::fegetround();
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        });
    };
    ask();
    std::fesetround(FE_UPWARD);
    ask();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(modes, std::vector<int>(count, FE_UPWARD));
    ask();
    EXPECT_EQ(modes, std::vector<int>(count, FE_TONEAREST));
}

TEST(ParallelChunks, OnThisThreadAlone) {
    std::vector<int> order;
    {
        const OnThisThreadAlone outer;
        { const OnThisThreadAlone inner; }
        forEachChunk(50, [&](int chunk) { order.push_back(chunk); });  // a race, were it not alone
        EXPECT_THROW(forEachChunk(2, [](int) { throw std::runtime_error("chunk"); }), std::runtime_error);
    }
    ASSERT_EQ(order.size(), 50u);
    for (int chunk = 0; chunk < 50; ++chunk) EXPECT_EQ(order[chunk], chunk);
}

/// Whether a helper comes for two chunks: neither ends before the other has begun, or a second is over.
bool othersTakePart() {
    std::atomic<int> on_others{0}, here{0};
    const std::thread::id own = std::this_thread::get_id();
    forEachChunk(2, [&](int) {
        ++here;
        for (int i = 0; i < 1000 && here < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (std::this_thread::get_id() != own) ++on_others;
    });
    return on_others > 0;
}

TEST(ParallelChunks, AloneUntilAnotherThreadWaits) {
    if (std::thread::hardware_concurrency() < 2 || !othersTakePart()) GTEST_SKIP() << "one core";
    std::atomic<bool> over{false};
    const OnThisThreadAlone alone(&over);
    EXPECT_FALSE(othersTakePart());
    over = true;
    EXPECT_TRUE(othersTakePart());
    const OnThisThreadAlone for_good;
    const OnThisThreadAlone inner(&over);
    EXPECT_FALSE(othersTakePart());
}

TEST(ParallelChunks, ThreadsWithWorkOfTheirOwnKeepTheirCores) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    if (cores < 2 || !othersTakePart()) GTEST_SKIP() << "one core";
    std::atomic<int> at_work{0};
    std::atomic<bool> over{false};
    std::vector<std::thread> threads;
    for (int i = 1; i < cores; ++i)
        threads.emplace_back([&] {
            const HasOwnWork work;
            const HasOwnWork counts_once;
            ++at_work;
            while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        });
    while (at_work < cores - 1) std::this_thread::yield();
    EXPECT_FALSE(othersTakePart());
    over = true;
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(othersTakePart());
    const HasOwnWork own;
    EXPECT_TRUE(othersTakePart()) << "what shares out is not in its own way";
}

}  // namespace
}  // namespace sherd
