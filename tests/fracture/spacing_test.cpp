#include "fracture/spacing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sherd {
namespace {

// A sheet of a thousandth of its width got ten thousand particles: enough of them one above the other, which
// there is no room for.
TEST(FragmentSpacing, OfASheetIsThatOfOneLayer) {
    const SamplingSettings sampling;
    for (const double thickness_m : {1e-3, 1e-4, 1e-5}) {
        const double spacing = fragmentSpacing(1, sampling, thickness_m, 2 + 4 * thickness_m);
        const double in_a_layer = 1 / (spacing * spacing);
        EXPECT_GT(in_a_layer, 64);
        EXPECT_LT(in_a_layer, 300);
    }
}

TEST(FragmentSpacing, OfAChunkLeavesItAFewDozenParticles) {
    const SamplingSettings sampling;
    EXPECT_NEAR(fragmentSpacing(1, sampling, 1, 6), 0.25, 1e-12);
    EXPECT_NEAR(fragmentSpacing(1, sampling, 0.1, 2.4), std::cbrt(0.1 / 64), 1e-12);  // a tile
    EXPECT_NEAR(fragmentSpacing(0.01, sampling, 1, 6), 0.02, 1e-12);
}

}  // namespace
}  // namespace sherd
