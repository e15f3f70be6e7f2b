#include "core/loads/surface_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/loads/footprint.h"
#include "core/loads/load_patch.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"
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

/// A solid cylinder that stands on z = 0, in triangles of about 1 / `fine` of its radius.
TriangleMesh cylinder(int fine) {
    std::vector<std::pair<double, double>> profile;
    for (int i = 0; i <= fine; ++i) profile.emplace_back(0.05 * i / fine, 0);
    for (int i = 1; i <= 2 * fine; ++i) profile.emplace_back(0.05, 0.05 * i / fine);
    for (int i = fine - 1; i >= 0; --i) profile.emplace_back(0.05 * i / fine, 0.1);
    return shapes::revolvedSolid(profile, 6 * fine);
}

/// What contacts see of a surface: about a point on its side, pressed there, and standing on its foot.
struct Seen {
    double around_m2 = 0, pressed_m2 = 0, foot_m2 = 0;
    Vec3 around_centre = Vec3::Zero(), pressed_centre = Vec3::Zero();
    std::size_t parts = 0;
};

Seen seenOf(const TriangleMesh& mesh) {
    const SurfaceTree tree(mesh);
    Seen seen;
    const Vec3 push(-0.6, -0.8, 0), spot = Vec3(0.03, 0.04, 0.031);
    constexpr double reach = 0.02;
    for (const PieceNearby& piece : surfaceAround(tree, spot, reach, 0.005, 0.002)) {
        // Pieces that reach out of it are there, or are not.
        const double inside = std::max(0.0, 1 - (piece.centre - spot).squaredNorm() / (reach * reach));
        const double weight = inside * inside * piece.area.norm();
        seen.around_m2 += weight;
        seen.around_centre += weight * piece.centre;
        ++seen.parts;
    }
    for (const PatchPart& part : partsOfPatch(tree, nearestSurfacePoint(tree, spot, push), push, 0.01, 0.2)) {
        seen.pressed_m2 += part.weight_m2;
        seen.pressed_centre += part.weight_m2 * part.centre;
        ++seen.parts;
    }
    const Footprint foot({{0.03, 0, 0}, {-0.03, 0, 0}, {0, 0.03, 0}, {0, -0.03, 0}}, Vec3::UnitZ(), 0.002);
    for (const FootprintPart& part : partsOver(
             tree, foot, [](const Vec2&, double) { return 0.004; }, 0.001)) {
        seen.foot_m2 += part.area_m2;
        ++seen.parts;
    }
    seen.around_centre /= seen.around_m2;
    seen.pressed_centre /= seen.pressed_m2;
    return seen;
}

TEST(SurfaceTree, AFinerMeshIsTheSameSurfaceInAsManyParts) {
    const Seen coarse = seenOf(cylinder(24)), fine = seenOf(cylinder(200));
    EXPECT_LT(fine.parts, 5 * coarse.parts) << "of 70 times the triangles";
    EXPECT_NEAR(fine.around_m2, coarse.around_m2, 0.01 * coarse.around_m2);
    EXPECT_NEAR(fine.pressed_m2, coarse.pressed_m2, 0.02 * coarse.pressed_m2);
    EXPECT_NEAR(fine.foot_m2, coarse.foot_m2, 0.03 * coarse.foot_m2);
    EXPECT_LT((fine.around_centre - coarse.around_centre).norm(), 1e-4);
    EXPECT_LT((fine.pressed_centre - coarse.pressed_centre).norm(), 1e-4);
}

TEST(SurfaceTree, PartsThatAreTakenTogetherAreAllOfTheSurface) {
    const TriangleMesh mesh = cylinder(60);
    const SurfaceParts parts = SurfaceTree(mesh).partsWhere(
        [](const Eigen::AlignedBox3d&) { return true; },
        [](const Eigen::AlignedBox3d& box) { return box.diagonal().norm() < 0.01; });
    Vec3 sum = Vec3::Zero();
    double volumes = 0, size = 0;  // volumes: three times the body's
    const auto add = [&](const Vec3& centre, const Vec3& area) {
        sum += area;
        volumes += centre.dot(area);
        size += area.norm();
    };
    for (const int t : parts.triangles) {
        const TriangleCorners corners = cornersOf(mesh, t);
        add((corners[0] + corners[1] + corners[2]) / 3, areaVector(corners));
    }
    for (const FlatPart& part : parts.flat) add(part.centre, part.area);
    EXPECT_GT(parts.flat.size(), 100u);
    EXPECT_LT(20 * (parts.flat.size() + parts.triangles.size()), mesh.triangles.size());
    EXPECT_LT(sum.norm(), 1e-6 * size) << "the surface is closed";
    EXPECT_NEAR(volumes / 3, pi * 0.05 * 0.05 * 0.1, 2e-3 * pi * 0.05 * 0.05 * 0.1);
    EXPECT_NEAR(size, surfaceArea(mesh), 2e-3 * surfaceArea(mesh));
}

}  // namespace
