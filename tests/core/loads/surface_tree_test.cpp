#include "core/loads/surface_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/loads/footprint.h"
#include "core/loads/load_patch.h"
#include "core/numerics/mesh_measures.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

TriangleMesh cup() {
    return shapes::cup(0.04, 0.09, 0.004, 24, 12);
}

std::vector<Vec3> somePlaces() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> wide(-0.08, 0.12);
    std::vector<Vec3> places;
    for (int i = 0; i < 200; ++i) places.emplace_back(wide(random), wide(random), wide(random));
    return places;
}

TEST(SurfaceTree, FindsAllThatIsNear) {
    const TriangleMesh mesh = cup();
    const SurfaceTree tree(mesh);
    for (const Vec3& place : somePlaces()) {
        const double radius = 0.02;
        std::vector<int> wanted;
        for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
            Eigen::AlignedBox3d box;
            for (const Vec3& corner : cornersOf(mesh, t)) box.extend(corner);
            if (box.squaredExteriorDistance(place) <= radius * radius) wanted.push_back(t);
        }
        const std::vector<int> found = tree.trianglesNear(place, radius);
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        EXPECT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()));
        EXPECT_LE(found.size(), 2 * wanted.size() + 64) << "a tree that finds all saves nothing";
    }
}

// Bit by bit, the first of equals included: a vertex is as near on all triangles around it.
TEST(SurfaceTree, FindsTheNearestThatALookAtAllFinds) {
    const TriangleMesh mesh = cup();
    const SurfaceTree tree(mesh);
    std::vector<Vec3> places = somePlaces();
    places.insert(places.end(), mesh.vertices.begin(), mesh.vertices.begin() + 100);
    for (const Vec3& place : places) {
        const auto squared = [&](int t) {
            double least = std::numeric_limits<double>::infinity();
            for (const Vec3& corner : cornersOf(mesh, t))
                least = std::min(least, (corner - place).squaredNorm());
            return least;
        };
        int wanted = 0;
        for (int t = 1; t < static_cast<int>(mesh.triangles.size()); ++t)
            if (squared(t) < squared(wanted)) wanted = t;
        EXPECT_EQ(tree.nearest(place, squared), wanted);
    }
}

TEST(SurfaceTree, OfNothingFindsNothing) {
    const TriangleMesh nothing;
    const SurfaceTree tree(nothing);
    EXPECT_TRUE(tree.trianglesNear(Vec3::Zero(), 1).empty());
    EXPECT_EQ(tree.nearest(Vec3::Zero(), [](int) { return 0.0; }), -1);
}

TEST(SurfaceTree, APushThatNothingFacesGetsTheNearestOfAll) {
    TriangleMesh sheet;
    sheet.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    sheet.triangles = {{0, 1, 2}};
    const SurfaceSpot spot = nearestSurfacePoint(SurfaceTree(sheet), Vec3(0.2, 0.2, 1), Vec3::UnitZ());
    EXPECT_EQ(spot.triangle, 0);
    EXPECT_LT((spot.point - Vec3(0.2, 0.2, 0)).norm(), 1e-15);
}

TEST(SurfaceTree, HasAllPartsOverAFootprint) {
    const TriangleMesh mesh = shapes::box(Vec3(-1, -1, 0), Vec3(1, 1, 0.5), 20, 20, 4);
    const Footprint footprint({Vec3(-0.3, -0.2, 0), Vec3(0.4, -0.2, 0), Vec3(0.4, 0.5, 0)}, Vec3::UnitZ(),
                              0.05);
    double area = 0;
    for (const FootprintPart& part : partsOver(
             SurfaceTree(mesh), footprint, [](const Vec2&, double) { return 0.01; }, 0.02))
        area += part.area_m2;
    const double legs = 0.7, margin = 0.05, pi = std::acos(-1.0);
    const double wanted = legs * legs / 2 + (2 + std::sqrt(2.0)) * legs * margin + pi * margin * margin;
    EXPECT_NEAR(area, wanted, 0.02 * wanted);
}

}  // namespace
