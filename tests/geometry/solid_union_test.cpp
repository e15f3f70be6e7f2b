#include "geometry/solid_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <random>
#include <thread>

#include "core/numerics/fibonacci_sphere.h"
#include "core/numerics/pi.h"
#include "geometry/mass_properties.h"
#include "geometry/surface_checks.h"
#include "geometry/surface_topology.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

std::vector<Vec3> box(const Vec3& low, const Vec3& high) {
    return shapes::box(low, high).vertices;
}

int shellCount(const TriangleMesh& mesh) {
    const auto edges = closedManifoldEdges(mesh);
    if (!edges) return -1;
    int count = 0;
    for (const int shell : shellOfTriangle(mesh, edges.value())) count = std::max(count, shell + 1);
    return count;
}

void expectUnion(const std::vector<std::vector<Vec3>>& parts, double volume, int shells,
                 double tolerance = 1e-12) {
    const Result<TriangleMesh> mesh = uniteConvexParts(parts);
    ASSERT_TRUE(mesh.ok()) << mesh.error();
    EXPECT_EQ(checkSurface(mesh.value()).error(), "");
    EXPECT_NEAR(solidMoments(mesh.value()).volume, volume, tolerance * volume);
    EXPECT_EQ(shellCount(mesh.value()), shells);
}

std::vector<Vec3> capsule(const Vec3& along, double radius) {
    constexpr int count = 256;
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const Vec3 out = fibonacciDirection(i, count);
        points.push_back(radius * out + (out.dot(along) > 0 ? 1 : -1) * along);
    }
    return points;
}

std::vector<Vec3> prism(int sides) {
    std::vector<Vec3> points;
    for (const double z : {0.0, 0.1, 0.2})
        for (int i = 0; i < sides; ++i)
            points.emplace_back(std::cos(2 * pi * i / sides), std::sin(2 * pi * i / sides), z);
    return points;
}

/// How many of 30 unions of the same parts, in three threads, differ from the first one.
int othersThanTheFirst(const std::vector<std::vector<Vec3>>& parts) {
    std::mutex mutex;
    std::vector<TriangleMesh> meshes;
    const auto work = [&](unsigned seed) {
        std::mt19937 random(seed);
        std::vector<std::unique_ptr<char[]>> others;
        for (int i = 0; i < 10; ++i) {
            for (int k = 0; k < 500; ++k) {
                others.push_back(std::make_unique<char[]>(16 + random() % 30000));
                if (random() % 2) others[random() % others.size()] = nullptr;
            }
            const Result<TriangleMesh> mesh = uniteConvexParts(parts);
            const std::lock_guard<std::mutex> lock(mutex);
            meshes.push_back(mesh ? mesh.value() : TriangleMesh());
        }
    };
    std::vector<std::thread> threads;
    for (unsigned seed = 1; seed <= 3; ++seed) threads.emplace_back(work, seed);
    for (std::thread& thread : threads) thread.join();
    EXPECT_FALSE(meshes[0].vertices.empty());
    return static_cast<int>(std::count_if(meshes.begin(), meshes.end(), [&](const TriangleMesh& mesh) {
        return mesh.vertices != meshes[0].vertices || mesh.triangles != meshes[0].triangles;
    }));
}

// CGAL goes by addresses where it has a choice, and those differ with what else there is.
TEST(SolidUnion, GivesTheSameBitsWhateverElseIsInMemory) {
    EXPECT_EQ(othersThanTheFirst({prism(60)}), 0);
    EXPECT_EQ(othersThanTheFirst({capsule(Vec3(0, 0.2, 0), 0.07), capsule(Vec3(0.19, 0.07, 0.02), 0.06),
                                  box(Vec3(-0.1, -0.1, -0.03), Vec3(0.3, 0.3, 0.03))}),
              0);
}

TEST(SolidUnion, AHullHasNoPointsInsideOfItsFacesOrEdges) {
    auto points = box(Vec3(0, 0, 0), Vec3(1, 2, 3));
    for (int i = 0; i < 60; ++i)
        points.emplace_back(0.25 * (i % 5), 0.5 * (i % 4 + 0.5), 1.0 * (i % 3 + 0.5));
    for (const double z : {1.0, 2.0}) points.emplace_back(0, 0, z);
    const Result<TriangleMesh> mesh = uniteConvexParts({points});
    ASSERT_TRUE(mesh.ok()) << mesh.error();
    EXPECT_EQ(mesh.value().vertices.size(), 8u);
    EXPECT_EQ(mesh.value().triangles.size(), 12u);
    EXPECT_EQ(checkSurface(mesh.value()).error(), "");
}

TEST(SolidUnion, OnePartIsItsHull) {
    auto corners = box(Vec3(0, 0, 0), Vec3(1, 2, 3));
    corners.emplace_back(0.5, 0.5, 0.5);  // inside
    expectUnion({corners}, 6, 1);
}

TEST(SolidUnion, BoxesThatTouchInAFaceMerge) {
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 0, 0), Vec3(2, 1, 1))}, 2, 1);
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 0.2, 0.3), Vec3(2, 0.7, 2))}, 1 + 0.5 * 1.7,
                1);
}

TEST(SolidUnion, SinglePrecisionBoxesMerge) {
    // Faces that should be one miss each other by a rounding: once a gap, once an overlap.
    for (const double miss : {-3e-8, 3e-8})
        expectUnion(
            {box(Vec3(0, 0, 0), Vec3(0.2, 1, 1)), box(Vec3(0.2 + miss, miss, 0), Vec3(0.4, 1, 1 - miss))},
            0.4, 1, 1e-6);
}

TEST(SolidUnion, OverlapsCountOnce) {
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(0.5, 0.5, 0.5), Vec3(1.5, 1.5, 1.5))}, 2 - 0.125,
                1);
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(0.25, 0.25, 0.25), Vec3(0.5, 0.5, 0.5))}, 1, 1);
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(0, 0, 0), Vec3(1, 1, 1))}, 1, 1);
}

TEST(SolidUnion, ThreeBoxesMakeAnL) {
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 0, 0), Vec3(2, 1, 1)),
                 box(Vec3(0, 1, 0), Vec3(1, 2, 1))},
                3, 1);
}

TEST(SolidUnion, DisjointPartsStayShells) {
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(2, 0, 0), Vec3(3, 1, 1)),
                 box(Vec3(0, 5, 0), Vec3(1, 6, 1))},
                3, 3);
}

TEST(SolidUnion, ASphereStuckInABox) {
    const TriangleMesh sphere = shapes::moved(shapes::icosphere(0.4, 2), shapes::tilt(), Vec3(0.5, 0.5, 1));
    const Result<TriangleMesh> mesh = uniteConvexParts({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), sphere.vertices});
    ASSERT_TRUE(mesh.ok()) << mesh.error();
    EXPECT_EQ(checkSurface(mesh.value()).error(), "");
    // The icosphere is symmetric about its centre, so half of it stands out.
    EXPECT_NEAR(solidMoments(mesh.value()).volume, 1 + solidMoments(sphere).volume / 2, 1e-6);
}

TEST(SolidUnion, TurnedBoxesMerge) {
    // Side faces that were one plane are apart by a rounding after the turn, once in double, once in single
    // precision.
    const TriangleMesh left = shapes::moved(shapes::box(Vec3(0, 0, 0), Vec3(1.01, 1, 1)), shapes::tilt());
    const TriangleMesh right = shapes::moved(shapes::box(Vec3(1, 0, 0), Vec3(2, 1, 1)), shapes::tilt());
    expectUnion({left.vertices, right.vertices}, 2, 1, 1e-5);
    std::vector<std::vector<Vec3>> single = {left.vertices, right.vertices};
    for (auto& part : single)
        for (Vec3& point : part) point = point.cast<float>().cast<double>();
    expectUnion(single, 2, 1, 1e-5);
}

TEST(SolidUnion, ACornerThatALaterPartFillsIsNoTrouble) {
    expectUnion({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 1, 0), Vec3(2, 2, 1)),
                 box(Vec3(1, 0, 0), Vec3(2, 1, 1))},
                3, 1);
}

TEST(SolidUnion, ContactInAnEdgeOrAPointHasASentence) {
    const std::string edge =
        uniteConvexParts({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 1, 0), Vec3(2, 2, 1))}).error();
    EXPECT_EQ(edge,
              "Convex part 1 touches the others in an edge or a point only, so the union is no solid; let "
              "parts overlap, "
              "meet in faces, or stay apart.");
    const std::string point =
        uniteConvexParts({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(1, 1, 1), Vec3(2, 2, 2))}).error();
    EXPECT_NE(point.find("point"), std::string::npos) << point;
}

TEST(SolidUnion, PartsThatAreNoSolidHaveASentence) {
    EXPECT_EQ(uniteConvexParts({}).error(), "There are no convex parts to unite; give at least one.");
    EXPECT_EQ(uniteConvexParts({box(Vec3(0, 0, 0), Vec3(1, 1, 0))}).error(),
              "Convex part 0 is flat; give it a thickness, or remove it.");
    EXPECT_EQ(uniteConvexParts({box(Vec3(0, 0, 0), Vec3(1, 1, 1)), {Vec3(0, 0, 0), Vec3(1, 1, 1)}}).error(),
              "Convex part 1 is flat; give it a thickness, or remove it.");
    EXPECT_EQ(uniteConvexParts({{}}).error(), "Convex part 0 has no points; remove it.");
}

}  // namespace
