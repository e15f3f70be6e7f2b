#include "geometry/cutting/chain_subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "geometry/cutting/triangle_subdivision.h"

namespace sherd {
namespace {

using Segments = std::vector<std::pair<int, int>>;

/// A triangle with a point on each of two sides, and as many between these two as wanted.
struct Crossed {
    std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.6, 0, 0}, {0, 0.6, 0}};
    std::vector<int> loop = {0, 3, 1, 2, 4};
    Segments chain;

    Crossed(int inner, unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> off(-0.25, 0.2);
        int last = 3;
        for (int i = 1; i <= inner; ++i) {
            const double s = i / (inner + 1.0);
            points.push_back((1 - s) * points[3] + s * points[4] + Vec3(1, 1, 0) * off(random) * s * (1 - s));
            chain.emplace_back(last, static_cast<int>(points.size()) - 1);
            last = chain.back().second;
        }
        chain.emplace_back(last, 4);
    }
};

double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b - a).cross(c - a).z();
}

bool isInCircle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Mat3 m;
    for (int r = 0; r < 3; ++r) {
        const Vec3 e = (r == 0 ? a : r == 1 ? b : c) - d;
        m.row(r) = Vec3(e.x(), e.y(), e.squaredNorm());
    }
    return m.determinant() > 1e-12;
}

TEST(ChainSubdivision, IsAConstrainedDelaunayTriangulation) {
    ChainSubdivision subdivision;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Crossed crossed(static_cast<int>(seed % 12), seed);
        const std::vector<Vec3>& x = crossed.points;
        std::vector<Triangle> triangles;
        TrianglePolygons polygons;
        ASSERT_TRUE(subdivision.split(x, Vec3::UnitZ(), crossed.loop, crossed.chain, triangles, polygons));
        double area = 0;
        std::map<std::pair<int, int>, int> opposite;  // of each directed edge
        for (const auto& [a, b, c] : triangles) {
            EXPECT_GT(turn(x[a], x[b], x[c]), 0);
            area += turn(x[a], x[b], x[c]) / 2;
            opposite[{a, b}] = c, opposite[{b, c}] = a, opposite[{c, a}] = b;
        }
        EXPECT_NEAR(area, 0.5, 1e-12);
        std::set<std::pair<int, int>> constraints;
        for (const auto& [a, b] : crossed.chain) {
            EXPECT_TRUE(opposite.count({a, b}) && opposite.count({b, a}));
            constraints.insert(std::minmax(a, b));
        }
        for (const auto& [edge, c] : opposite) {
            const auto [a, b] = edge;
            const auto other = opposite.find({b, a});
            if (other == opposite.end() || constraints.count(std::minmax(a, b))) continue;
            EXPECT_FALSE(isInCircle(x[a], x[b], x[c], x[other->second])) << seed;
        }
    }
}

// At each edge of the loop, and on either side of each segment, is the polygon of the triangle there.
void expectPolygonsOfParts(const std::vector<int>& loop, const std::vector<std::pair<int, int>>& segments,
                           const std::vector<Triangle>& triangles, const TrianglePolygons& polygons) {
    std::map<std::pair<int, int>, int> polygon_at;  // directed edges
    ASSERT_EQ(polygons.of_part.size(), triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        EXPECT_LT(polygons.of_part[t], polygons.count);
        for (int i = 0; i < 3; ++i)
            polygon_at[{triangles[t][i], triangles[t][(i + 1) % 3]}] = polygons.of_part[t];
    }
    for (std::size_t k = 0; k < loop.size(); ++k)
        EXPECT_EQ(polygons.at_edge[k], polygon_at.at({loop[k], loop[(k + 1) % loop.size()]}));
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const auto [a, b] = segments[s];
        EXPECT_EQ(polygons.beside_segments[s][0], polygon_at.at({a, b}));
        EXPECT_EQ(polygons.beside_segments[s][1], polygon_at.at({b, a}));
        EXPECT_NE(polygons.beside_segments[s][0], polygons.beside_segments[s][1]);
    }
}

TEST(ChainSubdivision, TellsThePolygonsBesideSegments) {
    ChainSubdivision subdivision;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Crossed crossed(static_cast<int>(seed % 12), seed);
        std::vector<Triangle> triangles;
        TrianglePolygons polygons;
        ASSERT_TRUE(subdivision.split(crossed.points, Vec3::UnitZ(), crossed.loop, crossed.chain, triangles,
                                      polygons));
        EXPECT_EQ(polygons.count, 2);
        expectPolygonsOfParts(crossed.loop, crossed.chain, triangles, polygons);
    }
}

// A hole in a triangle is a polygon too.
TEST(TriangleSubdivision, TellsThePolygonsBesideSegments) {
    TriangleSubdivision subdivision;
    const std::vector<Vec3> points = {{0, 0, 0},     {1, 0, 0},     {0, 1, 0},
                                      {0.2, 0.2, 0}, {0.4, 0.2, 0}, {0.2, 0.4, 0}};
    const std::vector<int> loop = {0, 1, 2};
    const std::vector<std::pair<int, int>> segments = {{3, 4}, {4, 5}, {5, 3}};
    std::vector<Triangle> triangles;
    TrianglePolygons polygons;
    ASSERT_TRUE(subdivision.split(points, Vec3::UnitZ(), loop, segments, triangles, polygons));
    EXPECT_EQ(triangles.size(), 7u);
    EXPECT_EQ((std::set<int>(polygons.of_part.begin(), polygons.of_part.end()).size()), 2u);
    expectPolygonsOfParts(loop, segments, triangles, polygons);
}

TEST(ChainSubdivision, LeavesChainsThatAreClosedOrCrossToOthers) {
    ChainSubdivision subdivision;
    std::vector<Triangle> triangles;
    TrianglePolygons polygons;
    const std::vector<Vec3> points = {{0, 0, 0},     {1, 0, 0},     {0, 1, 0},     {0.2, 0.2, 0},
                                      {0.4, 0.2, 0}, {0.2, 0.4, 0}, {0.3, 0, 0},   {0.6, 0, 0},
                                      {0, 0.3, 0},   {0, 0.6, 0},   {0.5, 0.5, 0}, {0.3, 0.7, 0}};
    EXPECT_FALSE(
        subdivision.split(points, Vec3::UnitZ(), {0, 1, 2}, {{3, 4}, {4, 5}, {5, 3}}, triangles, polygons));
    const std::vector<int> loop = {0, 6, 7, 1, 2, 9, 8};
    EXPECT_FALSE(subdivision.split(points, Vec3::UnitZ(), loop, {{6, 9}, {7, 8}}, triangles, polygons));
    EXPECT_TRUE(triangles.empty());
    EXPECT_TRUE(subdivision.split(points, Vec3::UnitZ(), loop, {{6, 8}, {7, 9}}, triangles, polygons));
    EXPECT_EQ(triangles.size(), 5u);
}

}  // namespace
}  // namespace sherd
