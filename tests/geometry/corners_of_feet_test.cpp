#include "geometry/convex/corners_of_feet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"
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
    EXPECT_GE(cornersOf(mesh).size(), 16u);
    EXPECT_EQ(cornersOf(mesh).size(), cornersOf(table()).size());
}

TEST(CornersOfFeet, OneFaceAloneHasNone) {
    EXPECT_TRUE(cornersOf(boxMesh(Vec3(0.2, 0.1, 0.05))).empty());
    EXPECT_TRUE(cornersOf(cylinderMesh(0.1, 0.02, 128)).empty());
}

/// Upright, with grooves round it that are five tolerances deep.
TriangleMesh groovedCylinder() {
    constexpr int rings = 40, sides = 32;
    TriangleMesh mesh;
    for (int ring = 0; ring < rings; ++ring)
        for (int side = 0; side < sides; ++side) {
            const int i = ring * sides + side, next = ring * sides + (side + 1) % sides;
            const double angle = 2 * pi * side / sides, radius = 0.1 - (ring % 4 == 3 ? 5 * tolerance_m : 0);
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.005 * ring);
            if (ring + 1 == rings) continue;
            mesh.triangles.push_back({i, next, next + sides});
            mesh.triangles.push_back({i, next + sides, i + sides});
        }
    for (int side = 1; side + 1 < sides; ++side) {
        const int top = (rings - 1) * sides;
        mesh.triangles.push_back({0, side + 1, side});
        mesh.triangles.push_back({top, top + side, top + side + 1});
    }
    return mesh;
}

/// It has many faces in one plane, and between them hardly leaves that, as round sides that are rough.
TEST(CornersOfFeet, AGroovedSideHasNone) {
    EXPECT_TRUE(cornersOf(groovedCylinder()).empty());
}

/// Nothing presses where a body cannot stand.
TEST(CornersOfFeet, WhatIsInsideOfTheHullIsNoFoot) {
    // A top with two legs, and two shorter ones between them.
    const TriangleMesh mesh = shapes::rectilinear(
        {-0.4, -0.3, -0.2, -0.1, 0.1, 0.2, 0.3, 0.4}, {-0.1, 0.1}, {0, 0.1, 0.2, 0.3},
        [](int i, int, int k) { return k == 2 || i == 0 || i == 6 || (k == 1 && (i == 2 || i == 4)); });
    const std::vector<Vec3> corners = cornersOf(mesh);
    EXPECT_FALSE(corners.empty());
    for (const Vec3& corner : corners) EXPECT_NE(corner.z(), 0.1);
}

}  // namespace
