#include "core/numerics/plane_crossing.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace sherd;

struct Halves {
    std::vector<Vec3> below, above;
};

Halves cutAt(const std::vector<Vec3>& polygon, double z) {
    Halves halves;
    const auto height = [&](int i) { return polygon[i].z() - z; };
    walkAcrossPlane(
        static_cast<int>(polygon.size()), [&](int i) { return height(i) >= 0; },
        [&](int i, bool above) { (above ? halves.above : halves.below).push_back(polygon[i]); },
        [&](int i, int next, bool above) {
            EXPECT_EQ(above, height(i) >= 0);
            const Vec3 crossing = planeCrossing(polygon[i], height(i), polygon[next], height(next));
            halves.below.push_back(crossing);
            halves.above.push_back(crossing);
        });
    return halves;
}

Vec3 areaOf(const std::vector<Vec3>& polygon) {
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i)
        area += 0.5 * (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
    return area;
}

const std::vector<Vec3> quad = {{0, 0, 0}, {2, 0, 0}, {2, 0, 4}, {0, 0, 2}};

TEST(PlaneCrossing, HalvesOfAPolygonTileItAndMeetInThePlane) {
    const Halves halves = cutAt(quad, 1);
    ASSERT_EQ(halves.below.size(), 4U);
    ASSERT_EQ(halves.above.size(), 4U);
    EXPECT_EQ(areaOf(halves.below), Vec3(0, -2, 0));
    EXPECT_EQ(areaOf(halves.above), Vec3(0, -4, 0));
    EXPECT_EQ(halves.below[2], Vec3(2, 0, 1));
    EXPECT_EQ(halves.below[3], Vec3(0, 0, 1));
}

TEST(PlaneCrossing, APolygonOnOneSideStaysWhole) {
    EXPECT_EQ(cutAt(quad, -1).above, quad);
    EXPECT_TRUE(cutAt(quad, -1).below.empty());
    EXPECT_EQ(cutAt(quad, 5).below, quad);
    EXPECT_EQ(cutAt(quad, 0).above, quad);  // corners in the plane count as above
}

}  // namespace
