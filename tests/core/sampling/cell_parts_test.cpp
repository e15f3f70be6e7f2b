#include "core/sampling/cell_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {
namespace {

const Vec3 size(1, 0.6, 0.4), offset(0.3, -0.2, 0.1);

/// The parts of a tilted box.
CellParts tiltedBox(MomentRule rule) {
    const Mat3 rotation =
        (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.7, Vec3::UnitY())).toRotationMatrix();
    SamplingSettings settings;
    settings.moment_order = 4;
    const auto sampled =
        sampleSolid(shapes::moved(shapes::slab(size), rotation, offset), 0.13, settings, rule);
    EXPECT_TRUE(sampled.ok()) << sampled.error();
    return sampled.ok() ? sampled.value().parts : CellParts{};
}

// Volume and centre of all parts against the box's own.
TEST(CellParts, MomentsAddUpToTheSolid) {
    for (const MomentRule rule : {MomentRule::exact, MomentRule::quick}) {
        const CellParts solid = tiltedBox(rule);
        double volume = 0;
        Vec3 first = Vec3::Zero();
        for (const CellPart& part : solid.parts) {
            const Vec3 middle =
                solid.origin + (part.cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.edges);
            const double cell = solid.edges.prod();
            volume += cell * part.fill;
            first += cell * part.fill * middle;
            if (part.moments.empty()) continue;
            const int n = solid.order + 1;
            first +=
                cell * Vec3(part.moments[1], part.moments[n], part.moments[n * n]).cwiseProduct(solid.edges);
        }
        EXPECT_NEAR(volume, size.prod(), 1e-12);
        EXPECT_LT((first / volume - offset).norm(), 1e-12);
    }
}

TEST(CellParts, QuickMomentsAreNearlyExact) {
    const CellParts exact = tiltedBox(MomentRule::exact), quick = tiltedBox(MomentRule::quick);
    ASSERT_EQ(quick.parts.size(), exact.parts.size());
    EXPECT_EQ(quick.neighbours, exact.neighbours);
    const int n = exact.order + 1;
    double largest = 0;
    for (std::size_t p = 0; p < exact.parts.size(); ++p) {
        EXPECT_NEAR(quick.parts[p].fill, exact.parts[p].fill, 1e-13);
        ASSERT_EQ(quick.parts[p].moments.size(), exact.parts[p].moments.size());
        for (int i = 0; i < static_cast<int>(exact.parts[p].moments.size()); ++i) {
            const double error = std::abs(quick.parts[p].moments[i] - exact.parts[p].moments[i]);
            largest = std::max(largest, error);
            const bool is_low = i % n + i / n % n + i / n / n <= 2;
            EXPECT_LT(error, is_low ? 1e-13 : 1e-3) << i;
        }
    }
    EXPECT_GT(largest, 0);
    EXPECT_LT(largest, 1e-3);
}

}  // namespace
}  // namespace sherd
