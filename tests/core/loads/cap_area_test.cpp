#include "core/loads/cap_area.h"

#include <gtest/gtest.h>

#include <random>

#include "core/numerics/pi.h"

namespace sherd {
namespace {

const HalfSpace all{Vec3::UnitZ(), 1e9};

// A disc in a triangle, a triangle in a disc, a quarter of a disc at a corner, a half at an edge.
TEST(CapArea, HasTheAreasOfElementaryFigures) {
    const TriangleCorners wide = {Vec3(-9, -9, 0.3), Vec3(9, -9, 0.3), Vec3(0, 18, 0.3)};
    EXPECT_NEAR(capArea(wide, Vec3::Zero(), 0.5, all), pi * (0.25 - 0.09), 1e-12);
    EXPECT_EQ(capArea(wide, Vec3::Zero(), 0.3, all), 0);
    const TriangleCorners small = {Vec3(0.1, 0, 0), Vec3(0.4, 0, 0.1), Vec3(0, 0.3, -0.1)};
    EXPECT_NEAR(capArea(small, Vec3::Zero(), 2, all), areaVector(small).norm(), 1e-14);
    const TriangleCorners right = {Vec3(1, 1, 1), Vec3(9, 1, 1), Vec3(1, 9, 1)};
    EXPECT_NEAR(capArea(right, Vec3(1, 1, 1), 2, all), pi, 1e-12);
    EXPECT_NEAR(capArea(right, Vec3(4, 1, 1), 2, all), 2 * pi, 1e-12);
    EXPECT_NEAR(capArea(right, Vec3(4, 1, 1), 2, {Vec3::UnitX(), 4}), pi, 1e-12);
    EXPECT_EQ(capArea(right, Vec3(4, 1, 1), 2, {Vec3::UnitZ(), 0.9}), 0);
    EXPECT_EQ(capArea({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX()}, Vec3::Zero(), 2, all), 0);
}

// Against 400,000 random points of each of 60 triangles, to within four standard deviations of their share.
TEST(CapArea, MatchesRandomPoints) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in_box(-1, 1), unit(0, 1);
    const auto anywhere = [&] { return Vec3(in_box(random), in_box(random), in_box(random)); };
    int partial = 0;
    for (int k = 0; k < 60; ++k) {
        const TriangleCorners t = {anywhere(), anywhere(), anywhere()};
        const HalfSpace below{anywhere().normalized(), 0.3 * in_box(random)};
        const Vec3 centre = 0.5 * anywhere();
        const double radius = 0.2 + 0.8 * unit(random), whole = areaVector(t).norm();
        constexpr int count = 400'000;
        int hits = 0;
        for (int i = 0; i < count; ++i) {
            double a = unit(random), b = unit(random);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const Vec3 x = t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
            hits += (x - centre).norm() <= radius && x.dot(below.normal) <= below.offset_m;
        }
        const double share = double(hits) / count;
        EXPECT_NEAR(capArea(t, centre, radius, below) / whole, share,
                    4 * std::sqrt(share * (1 - share) / count) + 1e-5);
        partial += share > 0.05 && share < 0.95;
    }
    EXPECT_GT(partial, 20);
}

}  // namespace
}  // namespace sherd
