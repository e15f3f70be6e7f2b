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

}  // namespace
}  // namespace sherd
