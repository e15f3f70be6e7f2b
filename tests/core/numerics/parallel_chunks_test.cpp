#include "core/numerics/parallel_chunks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
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

}  // namespace
}  // namespace sherd
