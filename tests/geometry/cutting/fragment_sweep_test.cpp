// The bodies of the scenes in small, cut many times.
#include <gtest/gtest.h>

#include <iostream>

#include "core/sampling/sample_solid.h"
#include "geometry/cutting/cut_checks.h"
#include "geometry/cutting/cut_fragments.h"
#include "geometry/cutting/fragment_support.h"
#include "geometry/cutting/swept_bodies.h"

namespace sherd {
namespace {

using namespace fragment_support;

constexpr unsigned seeds = 20;

class SweepOf : public testing::TestWithParam<SweptBody> {};

TEST_P(SweepOf, ManySeedsIsSound) {
    const TriangleMesh mesh = GetParam().mesh();
    const auto sampled = sampleSolid(mesh, GetParam().spacing, {});
    ASSERT_TRUE(sampled) << sampled.error();
    const Discretisation& solid = sampled.value();
    std::size_t checked = 0, notes = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const int count = 12 + static_cast<int>(25 * seed / (seeds - 1));
        const auto cut = cutFragments(mesh, solid, randomClusters(solid, count, seed), {seed});
        ASSERT_TRUE(cut) << cut.error();
        EXPECT_EQ(faultOfCut(mesh, cut.value()), "") << "seed " << seed;
        checked += cut.value().pieces.size();
        notes += cut.value().notes.size();
    }
    RecordProperty("pieces_checked", static_cast<int>(checked));
    std::cout << solid.particles.size() << " particles, " << checked << " pieces checked, " << notes
              << " notes\n";
    EXPECT_GE(checked, 0.95 * seeds * 24);
    EXPECT_EQ(notes, 0u);
}

INSTANTIATE_TEST_SUITE_P(Bodies, SweepOf,
                         testing::Values(SweptBody{"plate", plate, 1 / 22.0},
                                         SweptBody{"cup", coffeeCup, 0.004},
                                         SweptBody{"bowl", thinBowl, 0.005}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sherd
