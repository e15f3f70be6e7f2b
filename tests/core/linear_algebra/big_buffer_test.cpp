// Numbers of a factor: zero at first, and gone from the process when they are freed.

#include "core/linear_algebra/big_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "support/resident_memory.h"

namespace {

using sherd::BigBuffer;

TEST(BigBuffer, IsZeroAndAsLongAsAsked) {
    for (const std::size_t count :
         {std::size_t(0), std::size_t(1), std::size_t(1000), std::size_t(1) << 20}) {
        BigBuffer<float> buffer(count);
        ASSERT_EQ(buffer.size(), count);
        EXPECT_TRUE(std::all_of(buffer.data(), buffer.data() + count, [](float x) { return x == 0; }));
        std::fill(buffer.data(), buffer.data() + count, 1.0f);
        const BigBuffer<float> moved = std::move(buffer);
        EXPECT_EQ(moved.size(), count);
        EXPECT_TRUE(std::all_of(moved.data(), moved.data() + count, [](float x) { return x == 1; }));
    }
}

#ifdef __linux__
double residentMegabytes() {
    return sherd::residentBytes() / 1e6;
}

TEST(BigBuffer, GivesItsPagesBack) {
    // From now on the heap takes blocks of that size from what it has, and keeps them when they are freed.
    void* volatile large = std::malloc(30 << 20);
    std::free(large);
    const double before = residentMegabytes();
    // One of a large body, and those of some shards. A last buffer keeps the heap from giving back its end.
    for (const auto& [buffer_count, megabytes] : {std::pair(1, 16), std::pair(16, 1)}) {
        std::vector<BigBuffer<double>> buffers;
        for (int i = 0; i < buffer_count; ++i) {
            buffers.emplace_back(std::size_t(megabytes) << 17);
            std::fill(buffers.back().data(), buffers.back().data() + buffers.back().size(), 1.0);
        }
        EXPECT_GT(residentMegabytes() - before, 15);
        void* volatile kept = std::malloc(1 << 19);
        buffers.clear();
        EXPECT_LT(residentMegabytes() - before, 2);
        std::free(kept);
    }
}
#endif

}  // namespace
