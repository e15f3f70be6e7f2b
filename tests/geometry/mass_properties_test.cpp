#include "geometry/mass_properties.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace {

using namespace sherd;

/// Box with sides s: integral of (x - c)(x - c)^T = V/12 diag(s^2).
Mat3 boxSecondMoment(const Vec3& sides) {
    return sides.prod() / 12 * Mat3(sides.cwiseAbs2().asDiagonal());
}

TEST(MassProperties, BoxInClosedForm) {
    const Vec3 low(0.1, -0.2, 0.3), sides(0.4, 0.5, 0.06);
    const Moments moments = solidMoments(shapes::box(low, low + sides, 2, 3, 1));
    EXPECT_NEAR(moments.volume, sides.prod(), 1e-15);
    EXPECT_LT((moments.centroid - (low + sides / 2)).norm(), 1e-15);
    EXPECT_LT((moments.second - boxSecondMoment(sides)).norm(), 1e-15 * moments.second.norm() * 10);
}

TEST(MassProperties, TurningTheSolidTurnsTheMoments) {
    const Vec3 sides(1, 2, 3), offset(4, -5, 6);
    const Mat3 turn = shapes::tilt();
    const Moments moments = solidMoments(shapes::moved(shapes::slab(sides), turn, offset));
    EXPECT_LT((moments.centroid - offset).norm(), 1e-13);
    EXPECT_LT((moments.second - turn * boxSecondMoment(sides) * turn.transpose()).norm(), 1e-12);
}

TEST(MassProperties, FarFromTheOriginNoDigitsAreLost) {
    const Vec3 sides(0.01, 0.02, 0.005), offset(1000, -2000, 500);
    const Moments moments = solidMoments(shapes::translated(shapes::slab(sides), offset));
    // The vertices themselves are rounded to 2e-13 m there.
    EXPECT_NEAR(moments.volume / sides.prod(), 1, 1e-9);
    EXPECT_LT((moments.centroid - offset).norm(), 1e-12);
    EXPECT_LT((moments.second - boxSecondMoment(sides)).norm(), 1e-9 * boxSecondMoment(sides).norm());
}

TEST(MassProperties, CavitiesCountNegative) {
    const TriangleMesh outer = shapes::icosphere(1, 2), inner = shapes::icosphere(0.5, 2);
    const Moments hollow = solidMoments(shapes::hollowSphere(1, 0.5, 2));
    const Moments whole = solidMoments(outer), hole = solidMoments(inner);
    EXPECT_NEAR(hollow.volume, whole.volume - hole.volume, 1e-13);
    EXPECT_LT((hollow.second - (whole.second - hole.second)).norm(), 1e-13);
}

TEST(MassProperties, SphereConvergesWithTheSquareOfTheEdge) {
    const double exact = 4 * 3.14159265358979323846 / 3, exact_second = exact / 5;
    double errors[2];
    for (int level : {3, 4}) {
        const Moments moments = solidMoments(shapes::icosphere(1, level));
        errors[level - 3] = 1 - moments.volume / exact;
        EXPECT_NEAR(moments.second.trace() / 3, exact_second, 2 * errors[level - 3] * exact_second);
    }
    EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
}

TEST(MassProperties, FlatAndEmptySurfacesGiveNoVolume) {
    EXPECT_EQ(solidMoments({}).volume, 0);
    TriangleMesh sheet;
    sheet.vertices = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_EQ(solidMoments(sheet).volume, 0);
    EXPECT_TRUE(solidMoments(sheet).centroid.allFinite());
}

}  // namespace
