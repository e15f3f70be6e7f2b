#include "geometry/cutting/cap_triangulation.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

using Edges = std::vector<std::pair<int, int>>;

/// The corners of squares of given half sides about the origin, counter-clockwise in z = 0, and a place
/// beside them.
std::vector<Vec3> squares(const std::vector<double>& half_sides) {
    std::vector<Vec3> points;
    for (const double h : half_sides)
        for (const auto& [x, y] : {std::pair(-h, -h), {h, -h}, {h, h}, {-h, h}}) points.push_back({x, y, 0});
    return points;
}

/// The edges of four points that follow each other from `first` on.
void addLoop(int first, bool reversed, Edges& edges) {
    for (int i = 0; i < 4; ++i) {
        const int a = first + i, b = first + (i + 1) % 4;
        edges.push_back(reversed ? std::pair(b, a) : std::pair(a, b));
    }
}

double areaAbout(const Vec3& normal, const std::vector<Vec3>& points,
                 const std::vector<Triangle>& triangles) {
    double area = 0;
    for (const auto& [a, b, c] : triangles)
        area += 0.5 * (points[b] - points[a]).cross(points[c] - points[a]).dot(normal);
    return area;
}

TEST(CapTriangulation, LeavesHolesOpenAndFillsWhatLiesInThem) {
    const std::vector<Vec3> points = squares({3, 2, 1});
    Edges edges;
    addLoop(0, false, edges);
    addLoop(4, true, edges);
    addLoop(8, false, edges);
    const auto cap = triangulateCap(points, Vec3::UnitZ(), edges);
    ASSERT_TRUE(cap);
    EXPECT_NEAR(areaAbout(Vec3::UnitZ(), points, *cap), 36 - 16 + 4, 1e-12);
    for (const Triangle& triangle : *cap) EXPECT_GT(areaAbout(Vec3::UnitZ(), points, {triangle}), 0);
}

TEST(CapTriangulation, HasNothingToCloseWithoutEdges) {
    const auto cap = triangulateCap(squares({1}), Vec3::UnitZ(), {});
    ASSERT_TRUE(cap);
    EXPECT_TRUE(cap->empty());
}

TEST(CapTriangulation, RefusesWhatIsNoClosedLine) {
    const std::vector<Vec3> points = squares({1, 2});
    EXPECT_FALSE(triangulateCap(points, Vec3::UnitZ(), {{0, 1}, {1, 2}, {2, 3}}));          // open
    EXPECT_FALSE(triangulateCap(points, Vec3::UnitZ(), {{0, 2}, {2, 1}, {1, 3}, {3, 0}}));  // crosses itself
    EXPECT_FALSE(triangulateCap({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Vec3::UnitZ(), {{0, 1}, {1, 2}, {2, 0}}));
    EXPECT_FALSE(triangulateCap({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, Vec3::UnitZ(), {{0, 1}, {1, 2}, {2, 0}}));
}

}  // namespace
}  // namespace sherd
