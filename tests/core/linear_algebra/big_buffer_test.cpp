// Numbers of a factor: zero at first, and gone from the process when they are freed.

#include "core/linear_algebra/big_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

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
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    file >> pages >> pages;
    return pages * 4096 / 1e6;
}

TEST(BigBuffer, GivesItsPagesBack) {
    // From now on the heap takes blocks of that size from what it has, and keeps them when they are freed.
    void* volatile large = std::malloc(30 << 20);
    std::free(large);
    const double before = residentMegabytes();
    {
        BigBuffer<double> buffer(2 << 20);
        std::fill(buffer.data(), buffer.data() + buffer.size(), 1.0);
        EXPECT_GT(residentMegabytes() - before, 15);
    }
    EXPECT_LT(residentMegabytes() - before, 2);
}
#endif

}  // namespace
