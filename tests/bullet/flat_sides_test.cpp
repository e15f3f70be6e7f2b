// The sides of convex hulls.

#include "bullet/flat_sides.h"

#include <gtest/gtest.h>

#include <map>

#include "bullet/convex_hull.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

/// Every edge once in each direction: the sides close, and each is anticlockwise.
void expectClosed(const ConvexHull& hull) {
    std::map<std::pair<int, int>, int> edges;
    for (const FlatSide& side : hull.sides)
        for (std::size_t i = 0; i < side.corners.size(); ++i)
            ++edges[{side.corners[i], side.corners[(i + 1) % side.corners.size()]}];
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
}

/// How far a vertex is above the plane of a side.
double highestAboveASide(const ConvexHull& hull) {
    double highest = -1;
    for (const FlatSide& side : hull.sides) {
        double plane = -1e30;
        for (const int corner : side.corners) plane = std::max(plane, side.normal.dot(hull.vertices[corner]));
        for (const Vec3& vertex : hull.vertices) highest = std::max(highest, side.normal.dot(vertex) - plane);
    }
    return highest;
}

TEST(FlatSides, ABoxHasSixWithFourCorners) {
    for (const Mat3& turn : {Mat3(Mat3::Identity()), shapes::tilt()}) {
        std::vector<Vec3> points = shapes::slab(Vec3(0.03, 0.02, 0.002), 5, 7, 3).vertices;
        for (Vec3& point : points) point = turn * point;
        const ConvexHull hull = simpleHull(points, 96, 0);
        ASSERT_EQ(hull.sides.size(), 6u);
        for (const FlatSide& side : hull.sides) {
            EXPECT_EQ(side.corners.size(), 4u);
            EXPECT_NEAR((turn.transpose() * side.normal).lpNorm<Eigen::Infinity>(), 1, 1e-5);
        }
        EXPECT_NEAR(std::abs((turn.transpose() * hull.sides.front().normal).z()), 1, 1e-5) << "largest first";
        expectClosed(hull);
        EXPECT_LT(highestAboveASide(hull), 1e-7);
    }
}

/// A slab that is a little fuller in the middle has the same sides; one that is much fuller has more.
TEST(FlatSides, AreEvenUpToATolerance) {
    for (const double bulge : {0.05e-4, 4e-4}) {
        std::vector<Vec3> points = shapes::slab(Vec3(0.02, 0.02, 0.002), 8, 8, 1).vertices;
        for (Vec3& point : points)
            if (point.z() > 0) point.z() += bulge * (1 - point.head<2>().squaredNorm() / 2e-4);
        const ConvexHull hull = simpleHull(points, 96, 1e-6);
        int upward = 0;
        for (const FlatSide& side : hull.sides) upward += side.normal.z() > 0.7;
        EXPECT_EQ(upward == 1, bulge < 1e-4) << upward;
        EXPECT_LT(highestAboveASide(hull), 0.03 * 0.002);
    }
}

/// Points that lie in a plane up to a thousandth of what is even: no side faces inwards.
TEST(FlatSides, AreAllOutside) {
    std::vector<Vec3> points = shapes::slab(Vec3(0.02, 0.02, 0.002), 8, 8, 1).vertices;
    for (Vec3& point : points)
        if (point.z() > 0) point.z() += 2e-5 * (1 - point.head<2>().squaredNorm() / 2e-4);
    const ConvexHull hull = simpleHull(points, 96, 0);
    EXPECT_GT(hull.sides.size(), 5u);
    EXPECT_LT(highestAboveASide(hull), 0.05 * 0.002);
}

TEST(FlatSides, OfARoundHullClose) {
    for (const int most : {20, 40, 96}) {
        const ConvexHull hull = simpleHull(shapes::icosphere(0.01, 4).vertices, most, 0);
        EXPECT_GT(hull.sides.size(), hull.vertices.size() / 2);
        expectClosed(hull);
        EXPECT_LT(highestAboveASide(hull), 1e-8);
    }
}

TEST(FlatSides, PointsInAPlaneHaveNone) {
    EXPECT_TRUE(
        simpleHull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}, 96, 0).sides.empty());
    EXPECT_TRUE(flatSides({}, {}, 0).empty());
}

}  // namespace
