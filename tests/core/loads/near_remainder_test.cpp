#include "core/loads/near_remainder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/loads/contact_field.h"
#include "support/shapes.h"

namespace sherd {
namespace {

struct Missed {
    double largest_pa = 0, traction_pa = 0;
};

/// What a grid misses at a contact that presses straight along `push`.
Missed missedAt(const TriangleMesh& mesh, const Vec3& at, const Vec3& push, double radius, double spacing) {
    const SurfaceTree tree(mesh);
    const Material material = Material::ceramic();
    const ContactBody body{tree, material, {}, 0.1, 0.2};
    const SurfaceSpot spot = nearestSurfacePoint(tree, at, push);
    const ContactField field = contactField(
        body, {{spot, push, push, radius, partsOfPatch(tree, spot, push, radius, 0.18)}}, spacing);
    EXPECT_EQ(field.near.discs().size(), 1u);
    Missed missed;
    for (const ContactDisc& disc : field.near.discs())
        missed.traction_pa = std::max(missed.traction_pa, disc.traction_pa.norm());
    for (const SurfacePlace& place : field.places)
        missed.largest_pa = std::max(missed.largest_pa, toMatrix(place.unresolved).norm());
    return missed;
}

TEST(NearRemainder, IsNothingOnAPlane) {
    const TriangleMesh block = shapes::slab(Vec3(0.2, 0.2, 0.1), 4, 4, 2);
    const Missed missed = missedAt(block, Vec3(0.01, 0.02, 0.05), -Vec3::UnitZ(), 0.005, 0.02);
    EXPECT_LT(missed.largest_pa, 1e-3 * missed.traction_pa);
}

TEST(NearRemainder, IsMissedByCoarseGridsOnly) {
    const TriangleMesh ball = shapes::icosphere(0.05, 5);
    const auto missed = [&](double spacing) {
        const Missed found = missedAt(ball, Vec3(0, 0, 0.05), -Vec3::UnitZ(), 0.01, spacing);
        return found.largest_pa / found.traction_pa;
    };
    EXPECT_GT(missed(0.02), 0.05);
    EXPECT_NEAR(missed(0.04), missed(0.02), 0.2 * missed(0.02)) << "both see next to nothing";
    for (const double spacing : {0.02, 0.012, 0.008, 0.005, 0.003, 0.002})
        EXPECT_LT(missed(spacing), missed(1.5 * spacing)) << spacing;
    EXPECT_LT(missed(0.001), 1e-12) << "cells of a tenth of the contact see all";
}

TEST(NearRemainder, DoesNotDependOnHowFineTheMeshIs) {
    const Vec3 out = Vec3::UnitX();
    const auto missed = [&](const TriangleMesh& tube) {
        const Missed found = missedAt(tube, 0.05 * out, -out, 0.006, 0.02);
        return found.largest_pa / found.traction_pa;
    };
    const double coarse = missed(shapes::tube(0.05, 0.04, 0.3, 180)),
                 fine = missed(shapes::tube(0.05, 0.04, 0.3, 720));
    EXPECT_GT(coarse, 0.02);
    EXPECT_NEAR(fine, coarse, 0.2 * coarse);
}

// A ball is missed the same wherever it lies, however it is turned and however large it is.
TEST(NearRemainder, IsThatOfTheShapeAlone) {
    const auto missed = [&](double scale, const Mat3& turn, const Vec3& shift) {
        const Vec3 top = turn * Vec3::UnitZ();
        const TriangleMesh ball = shapes::moved(shapes::icosphere(0.05 * scale, 5), turn, shift);
        const Missed found = missedAt(ball, 0.05 * scale * top + shift, -top, 0.01 * scale, 0.02 * scale);
        return found.largest_pa / found.traction_pa;
    };
    const Mat3 as_it_is = Mat3::Identity();
    const double own = missed(1, as_it_is, Vec3::Zero());
    EXPECT_NEAR(missed(1000, as_it_is, Vec3::Zero()), own, 1e-6 * own);
    EXPECT_NEAR(missed(0.001, as_it_is, Vec3::Zero()), own, 1e-6 * own);
    EXPECT_NEAR(missed(1, as_it_is, Vec3(0.3, -0.2, 0.7)), own, 1e-3 * own);
    // The axes of its cubes turn with it, but for one that is chosen by chance.
    for (const double angle : {0.3, 0.9, 2.0}) {
        const Mat3 turn = Eigen::AngleAxisd(angle, Vec3(1, 2, 0.5).normalized()).toRotationMatrix();
        EXPECT_NEAR(missed(1, turn, Vec3::Zero()), own, 0.15 * own) << angle;
    }
}

// Two walls, 0.2 of the contact apart: nothing is heard of the second one across the air.
TEST(NearRemainder, KnowsNothingOfAnotherWall) {
    const TriangleMesh wall = shapes::box(Vec3(-0.05, -0.05, -0.001), Vec3(0.05, 0.05, 0), 20, 20, 1);
    const TriangleMesh two = shapes::joined(wall, shapes::translated(wall, Vec3(0, 0, -0.0012)));
    const Missed alone = missedAt(wall, Vec3::Zero(), -Vec3::UnitZ(), 0.001, 0.004),
                 with = missedAt(two, Vec3::Zero(), -Vec3::UnitZ(), 0.001, 0.004);
    EXPECT_GT(alone.largest_pa, 0.1 * alone.traction_pa);
    EXPECT_NEAR(with.largest_pa, alone.largest_pa, 0.25 * alone.largest_pa);
}

}  // namespace
}  // namespace sherd
