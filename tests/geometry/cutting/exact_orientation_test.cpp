#include "geometry/cutting/exact_orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sherd {
namespace {

// Points on the plane but for the rounding of their coordinates: floating point alone gets many signs wrong.
TEST(OrientedPlane, GivesExactSignsOfPointsNextToIt) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(0.1, 1);
    const auto point = [&] { return Vec3(coordinate(random), coordinate(random), coordinate(random)); };
    int wrong = 0;
    for (int round = 0; round < 2000; ++round) {
        const Vec3 a = point(), b = point(), c = point();
        const OrientedPlane plane(a, b, c);
        const Vec3 d = a + coordinate(random) * (b - a) + coordinate(random) * (c - a);
        const int exact = orientation(a, b, c, d);
        EXPECT_EQ(plane.side(d), exact);
        const double rounded = signedVolume(a, b, c, d);
        wrong += exact != (rounded > 0) - (rounded < 0);
    }
    EXPECT_GT(wrong, 100);
}

TEST(OrientedPlane, KnowsPointsOnIt) {
    const Vec3 a(0, 0, 0.25), b(1, 0, 0.25), c(0, 1, 0.25);
    const OrientedPlane plane(a, b, c);
    EXPECT_EQ(plane.side({3, -7, 0.25}), 0);
    EXPECT_EQ(plane.side({3, -7, std::nextafter(0.25, 1)}), 1);
    EXPECT_EQ(plane.side({3, -7, std::nextafter(0.25, 0)}), -1);
}

}  // namespace
}  // namespace sherd
