#include "core/mlpg/splines/spacing_choice.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace sherd {
namespace {

TEST(SpacingChoice, KeepsTheFactorWithinItsLimit) {
    const TriangleMesh slab = shapes::slab({1, 1, 0.1});
    const Result<double> free = chooseSpacing(slab, {0.05, 0.1, 2, 1e9, 1e9}, 2);
    ASSERT_TRUE(free.ok());
    EXPECT_DOUBLE_EQ(free.value(), 0.05);
    const Result<double> limited = chooseSpacing(slab, {0.01, 0.1, 2, 1e6, 1e6}, 2);
    ASSERT_TRUE(limited.ok());
    EXPECT_GT(limited.value(), 0.06);
    EXPECT_LT(limited.value(), 0.15);
    // Walls thinner than that spacing get more.
    const Result<double> thin = chooseSpacing(slab, {0.01, 0.07, 2, 1e6, 1e8}, 2);
    ASSERT_TRUE(thin.ok());
    EXPECT_NEAR(thin.value(), 0.07, 1e-12);
}

}  // namespace
}  // namespace sherd
