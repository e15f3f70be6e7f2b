#include "geometry/convex/corners_of_feet.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/convex/convex_hull.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

constexpr double tolerance_m = 1e-5;

std::vector<Vec3> cornersOf(const TriangleMesh& mesh) {
    return cornersOfFeet(mesh, simpleHull(mesh.vertices, 1024, tolerance_m).vertices, tolerance_m);
}

TriangleMesh table() {
    return shapes::rectilinear({-0.2, -0.16, 0.16, 0.2}, {-0.2, -0.16, 0.16, 0.2}, {0, 0.3, 0.34},
                               [](int i, int j, int k) { return k == 1 || (i != 1 && j != 1); });
}

TEST(CornersOfFeet, AreTheInnerOnes) {
    const std::vector<Vec3> corners = cornersOf(table());
    for (const double x : {-0.2, -0.16, 0.16, 0.2})
        for (const double y : {-0.2, -0.16, 0.16, 0.2})
            EXPECT_EQ(std::count(corners.begin(), corners.end(), Vec3(x, y, 0)), 1) << x << ", " << y;
    for (const Vec3& corner : corners)
        EXPECT_TRUE(corner.z() == 0 || std::abs(std::abs(corner.x()) - 0.2) < 1e-9 ||
                    std::abs(std::abs(corner.y()) - 0.2) < 1e-9)
            << "on a side on which it can stand, too";
}

TEST(CornersOfFeet, OfATurnedBodyAreAsMany) {
    TriangleMesh mesh = table();
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (Vec3& vertex : mesh.vertices) vertex = turn * vertex + Vec3(3, -1, 2);
    EXPECT_EQ(cornersOf(mesh).size(), cornersOf(table()).size());
}

TEST(CornersOfFeet, OneFaceAloneHasNone) {
    EXPECT_TRUE(cornersOf(boxMesh(Vec3(0.2, 0.1, 0.05))).empty());
    EXPECT_TRUE(cornersOf(cylinderMesh(0.1, 0.02, 128)).empty());
}

/// Nothing presses where a body cannot stand.
TEST(CornersOfFeet, WhatIsInsideOfTheHullIsNoFoot) {
    // A top with two legs, and two shorter ones between them.
    const TriangleMesh mesh = shapes::rectilinear(
        {-0.4, -0.3, -0.2, -0.1, 0.1, 0.2, 0.3, 0.4}, {-0.1, 0.1}, {0, 0.1, 0.2, 0.3},
        [](int i, int, int k) { return k == 2 || i == 0 || i == 6 || (k == 1 && (i == 2 || i == 4)); });
    for (const Vec3& corner : cornersOf(mesh)) EXPECT_NE(corner.z(), 0.1);
}

}  // namespace
