// The hulls that follow a solid, and what they are made with.

#include "geometry/convex/convex_decomposition.h"

#include <gtest/gtest.h>

#include <random>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"
#include "geometry/convex/convex_hull.h"
#include "geometry/convex/cut_tree.h"
#include "geometry/convex/growing_hull.h"
#include "geometry/convex/oriented_polytope.h"
#include "geometry/convex/possible_cuts.h"
#include "geometry/convex/surface_cloud.h"
#include "geometry/mass_properties.h"
#include "support/exact_hull.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

TriangleMesh cup() {
    return shapes::cup(0.2, 0.3, 0.04, 24, 4);
}

TEST(ConvexHull, HasTheVerticesAndTheVolumeOfTheSolid) {
    const ConvexHull box = exactHull(shapes::slab(Vec3(1, 2, 3), 4, 4, 4).vertices);
    EXPECT_EQ(box.vertices.size(), 8u);
    EXPECT_NEAR(box.volume, 6, 1e-5);
    EXPECT_EQ(exactHull({}).volume, 0);
    EXPECT_EQ(exactHull(std::vector<Vec3>(5, Vec3::Ones())).volume, 0);
}

TEST(ConvexHull, SimpleOneKeepsTheOutermostPoints) {
    const std::vector<Vec3> sphere = shapes::icosphere(0.05, 4).vertices;
    const ConvexHull few = simpleHull(sphere, 96, 1e-5);
    EXPECT_LE(few.vertices.size(), 96u);
    EXPECT_GT(few.volume, 0.9 * exactHull(sphere).volume);
    EXPECT_GT(few.outside, 1e-5);
    EXPECT_LT(few.outside, 0.05 * 0.1);
    const ConvexHull plate = simpleHull(shapes::slab(Vec3(1, 2, 0.01), 9, 9, 2).vertices, 42, 1e-4);
    EXPECT_EQ(plate.vertices.size(), 8u);
    EXPECT_NEAR(plate.volume, 0.02, 1e-5);
    EXPECT_TRUE(simpleHull({}, 64, 0).vertices.empty());
}

/// Parts of spheres, whose vertices lie on no line: as near to all of them as is asked for.
TEST(ConvexHull, SimpleOneIsWithinTheTolerance) {
    const std::vector<Vec3> points = shapes::icosphere(1, 3).vertices;
    for (const double tolerance : {0.1, 0.05}) {
        const ConvexHull hull = simpleHull(points, 1000, tolerance);
        EXPECT_LE(hull.outside, tolerance);
        EXPECT_LT(hull.vertices.size(), points.size() / 2);
        EXPECT_GT(hull.volume, std::pow(1 - tolerance, 3) * exactHull(points).volume);
    }
}

TEST(GrowingHull, HasTheCornersOfABoxOnly) {
    for (const Mat3& turn : {Mat3(Mat3::Identity()), shapes::tilt()}) {
        std::vector<Vec3> points = shapes::slab(Vec3(1, 2, 3), 5, 7, 9).vertices;
        for (Vec3& point : points) point = turn * point;
        GrowingHull hull(points);
        hull.growTo(100, 0);
        EXPECT_EQ(hull.vertices().size(), 8u);
        EXPECT_NEAR(hull.volume(), 6, 1e-5);
        EXPECT_EQ(hull.outside(), 0);
    }
}

/// Strips as thick as rounding, turned out of the axes: some of their points can not be added.
TEST(GrowingHull, OfPointsThatAreAlmostFlatEnds) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int strip = 0; strip < 2000; ++strip) {
        const Eigen::Quaterniond turn(any(random), any(random), any(random), any(random));
        std::vector<Vec3> points;
        for (int p = 0; p < 40; ++p)
            points.push_back(turn.normalized() * Vec3(any(random), 0.01 * any(random), 1e-4 * any(random)));
        GrowingHull hull(points);
        hull.growTo(96, 0);
        ASSERT_LE(hull.vertices().size(), points.size());
    }
}

TEST(GrowingHull, KnowsWhatIsFlat) {
    EXPECT_TRUE(GrowingHull({}).isFlat());
    EXPECT_TRUE(GrowingHull(std::vector<Vec3>(5, Vec3::Ones())).isFlat());
    EXPECT_TRUE(GrowingHull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}).isFlat());
    EXPECT_FALSE(GrowingHull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 1)}).isFlat());
}

/// The points inside a hull that grew are inside that of all points, and nothing is further out than it says.
TEST(GrowingHull, SaysHowFarPointsLieOutside) {
    const std::vector<Vec3> points = shapes::icosphere(1, 4).vertices;
    double before = 1;
    for (const int most : {30, 60, 120, 240}) {
        GrowingHull hull(points);
        hull.growTo(most, 0);
        EXPECT_LE(hull.vertices().size(), static_cast<std::size_t>(most));
        EXPECT_LT(hull.outside(), before);
        EXPECT_GT(hull.volume(), 4 * pi / 3 * std::pow(1 - hull.outside(), 3) * 0.98);
        before = hull.outside();
    }
}

std::vector<ConvexHull> partsOf(const TriangleMesh& solid, const DecompositionLimits& limits = {}) {
    return convexDecomposition(solid, solidMoments(solid).volume, limits);
}

TEST(ConvexDecomposition, LeavesConvexSolidsWhole) {
    EXPECT_EQ(partsOf(shapes::slab(Vec3(1, 2, 3), 4, 4, 4)).size(), 1u);
    EXPECT_EQ(partsOf(shapes::icosphere(1, 3)).size(), 1u);
}

TEST(ConvexDecomposition, MakesNoMorePartsThanAskedFor) {
    for (const int most : {1, 2, 5}) {
        DecompositionLimits limits;
        limits.most_parts = most;
        EXPECT_EQ(partsOf(cup(), limits).size(), static_cast<std::size_t>(most));
    }
}

TEST(ConvexDecomposition, FollowsHollows) {
    const TriangleMesh solids[] = {cup(), shapes::tube(0.2, 0.16, 0.1, 48),
                                   shapes::uShape(0.05, 0.2, 0.3, 0.2),
                                   shapes::moved(shapes::uShape(0.05, 0.2, 0.3, 0.2), shapes::tilt())};
    for (const TriangleMesh& solid : solids) {
        double volume = 0;
        const auto parts = partsOf(solid);
        for (const ConvexHull& part : parts) volume += part.volume;
        const double true_volume = solidMoments(solid).volume;
        EXPECT_GT(volume, 0.97 * true_volume);
        EXPECT_LT(volume, 1.3 * true_volume);
    }
}

/// As the legs and the floor of a U, which no plane on a grid meets.
TEST(ConvexDecomposition, CutsInTheFacesOfSteps) {
    DecompositionLimits limits;
    limits.most_parts = 3;
    const TriangleMesh solid = shapes::uShape(0.043, 0.2, 0.3, 0.2);
    double volume = 0;
    for (const ConvexHull& part : partsOf(solid, limits)) volume += part.volume;
    EXPECT_NEAR(volume / solidMoments(solid).volume, 1, 1e-4);
}

/// Two planes leave a quarter with an edge inside the solid, three a corner that no triangle has.
TEST(ConvexDecomposition, PartsHaveTheirCornersInsideTheSolid) {
    DecompositionLimits limits;
    limits.air_share_of_one_hull = limits.air_share = -1;  // cut what is convex, too
    for (const int most : {2, 4, 8, 16}) {
        limits.most_parts = most;
        double volume = 0;
        for (const ConvexHull& part : partsOf(shapes::slab(Vec3(1, 1, 1), 6, 6, 6), limits))
            volume += part.volume;
        EXPECT_NEAR(volume, 1, 1e-3) << most;  // corners close to the surface are left out
    }
}

TEST(CutTree, GivesFacesInAPlaneToTheSideOfTheSolid) {
    const TriangleMesh solid = shapes::uShape(0.05, 0.2, 0.3, 0.2);
    CutTree tree(1e-9);
    EXPECT_EQ(tree.cut(0, {2, 0.05}), 1);
    EXPECT_EQ(tree.cut(1, {0, 0.05}), 2);
    const auto points = tree.pointsOfLeaves(solid);
    ASSERT_EQ(points.size(), 3u);
    const auto box = [&](int leaf) { return boundingBox(points[leaf]); };
    EXPECT_TRUE(box(0).isApprox(Eigen::AlignedBox3d(Vec3(0, 0, 0), Vec3(0.3, 0.2, 0.05)), 1e-12));
    EXPECT_TRUE(box(1).isApprox(Eigen::AlignedBox3d(Vec3(0, 0, 0.05), Vec3(0.05, 0.2, 0.3)), 1e-12));
    EXPECT_TRUE(box(2).isApprox(Eigen::AlignedBox3d(Vec3(0.25, 0, 0.05), Vec3(0.3, 0.2, 0.3)), 1e-12))
        << "the top of the floor is not the leg's";
}

TEST(OrientedPolytope, HasTheVolumeOfWhatItStandsFor) {
    const auto of = [](const TriangleMesh& solid) {
        OrientedPolytope polytope;
        EXPECT_TRUE(polytope.empty());
        for (const Vec3& x : solid.vertices) polytope.add(OrientedPolytope::reachOf(x));
        return polytope;
    };
    EXPECT_NEAR(of(shapes::slab(Vec3(1, 2, 3), 1, 1, 1)).volume(), 6, 1e-12);
    EXPECT_NEAR(of(shapes::slab(Vec3(1, 2, 3), 1, 1, 1)).diagonal(), std::sqrt(14), 1e-12);
    // Of a sphere it is a prism over the octagon about its circle, whose area is 8 tan(pi / 8).
    EXPECT_NEAR(of(shapes::icosphere(1, 4)).volume(), 2 * 8 * std::tan(pi / 8), 0.05);
}

TEST(SurfaceCloud, MeasuresThePartsOfASolid) {
    const TriangleMesh solid = shapes::slab(Vec3(1, 2, 3), 4, 8, 12);
    const SurfaceCloud cloud = cloudOf(solid);
    EXPECT_NEAR(solidVolume(cloud), 6, 1e-3);
    const auto parts = parted(cloud, {2, 1.1});
    EXPECT_NEAR(solidVolume(parts[0]), 2 * 2.6, 0.15);
    EXPECT_NEAR(solidVolume(parts[1]), 2 * 0.4, 0.15);
    EXPECT_NEAR(GrowingHull(parts[0].points).volume(), 2 * 2.6, 1e-3) << "the section is there";
    EXPECT_TRUE(isWellInside(Vec3(0.1, 0.1, 0.1), cloud));
    EXPECT_FALSE(isWellInside(Vec3(0.1, 0.1, 1.499), cloud));
    EXPECT_FALSE(isWellInside(Vec3(0.1, 0.1, 2), cloud));
}

/// A tube whose walls are two rings of long slivers.
TEST(SurfaceCloud, HasNoMorePointsForSlivers) {
    const double pi_r2 = pi * (0.05 * 0.05 - 0.045 * 0.045);
    for (const int sides : {64, 512}) {
        const TriangleMesh tube = shapes::tube(0.05, 0.045, 0.3, sides);
        const SurfaceCloud cloud = cloudOf(tube);
        EXPECT_LT(cloud.points.size(), 8000u) << sides;
        EXPECT_NEAR(solidVolume(cloud), 0.3 * pi_r2, 0.05 * 0.3 * pi_r2) << sides;
        const auto parts = partsOf(tube);
        double volume = 0;
        for (const ConvexHull& part : parts) volume += part.volume;
        EXPECT_GE(parts.size(), 4u) << sides;
        EXPECT_LT(volume, 0.5 * pi * 0.05 * 0.05 * 0.3) << "the tube stays open; sides " << sides;
    }
}

TEST(SurfaceCloud, EndsAtAPlaneInAFace) {
    const SurfaceCloud cloud = cloudOf(shapes::uShape(0.05, 0.2, 0.3, 0.2));
    ASSERT_EQ((*cloud.steps)[0].size(), 4u);
    EXPECT_NEAR((*cloud.steps)[0][1].offset, 0.05, 1e-12);
    EXPECT_NEAR((*cloud.steps)[0][1].area, 0.2 * 0.25, 1e-12);
    const SurfaceCloud rest = parted(cloud, {0, 0.05})[1];
    for (std::size_t p = 0; p < rest.points.size(); ++p)
        EXPECT_TRUE(rest.points[p].z() < 0.05 + 2 * cloud.spacing || rest.points[p].x() > 0.249)
            << "of the leg below the plane";
}

}  // namespace
