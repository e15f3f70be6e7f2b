#include "core/numerics/hashed_random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace sherd;

TEST(SplitMix64, GivesTheSequenceOfItsAuthors) {
    // The first outputs of the published generator for the seed 1234567.
    const std::uint64_t outputs[] = {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL};
    std::uint64_t state = 1234567;
    for (const std::uint64_t output : outputs) {
        EXPECT_EQ(splitMix64(state), output);
        state += golden_step;
    }
}

TEST(HashedRandom, IsUniformAndUncorrelatedBetweenComponents) {
    constexpr int count = 20000;
    double sum = 0, squares = 0, products = 0;
    for (int i = 0; i < count; ++i) {
        const double a = hashedRandom(7, i, 0), b = hashedRandom(7, i, 1);
        EXPECT_TRUE(a >= -1 && a < 1);
        sum += a;
        squares += a * a;
        products += a * b;
    }
    // Five standard deviations of each mean.
    EXPECT_NEAR(sum / count, 0, 5 * std::sqrt(1 / 3.0 / count));
    EXPECT_NEAR(squares / count, 1 / 3.0, 5 * std::sqrt(4 / 45.0 / count));
    EXPECT_NEAR(products / count, 0, 5 / 3.0 / std::sqrt(count));
}

}  // namespace
