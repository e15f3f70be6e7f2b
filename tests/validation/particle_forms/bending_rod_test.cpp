#include "validation/bending_rod.h"

namespace sherd::validation::bending_rod {
namespace {

TEST(BendingRod, GmlsIsAccurateWithTwoParticlesAcrossAtAnyTilt) {
    for (double angle : {0.0, 0.2, 0.5, 0.8}) {
        const Mat3 tilt = (Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized())).toRotationMatrix();
        EXPECT_LT(bendingError(galerkin_gmls, side / 2, tilt), 0.12) << "tilt " << angle;
    }
}

TEST(BendingRod, MlsConverges) {
    const double coarse = bendingError(galerkin_mls, side / 2, Mat3::Identity());
    const double fine = bendingError(galerkin_mls, side / 4, Mat3::Identity());
    EXPECT_LT(fine, 0.06);
    EXPECT_LT(fine, coarse);
}

// Rows that balance forces alone: bending is underestimated, less with every layer. The solver says so.
TEST(BendingRod, HeavisideIsTooWeakInBendingAndWarns) {
    const double two = bendingError(heaviside_mls, side / 2, Mat3::Identity());
    const double four = bendingError(heaviside_mls, side / 4, Mat3::Identity());
    EXPECT_GT(two, 0.2);
    EXPECT_LT(four, two);
    const auto solid = sampled(shapes::slab({length, side, side}), side / 2);
    EXPECT_FALSE(build(solid, elasticMaterial(), heaviside_mls).report().warnings.empty());
}

// One layer of particles lies in a line: mls cannot see bending there and says so, gmls can.
TEST(BendingRod, OneParticleAcross) {
    EXPECT_LT(bendingError(galerkin_gmls, side, Mat3::Identity()), 1.0);
    const auto solid = sampled(shapes::slab({length, side, side}), side);
    ASSERT_EQ(solid->particles.size(), 10u);
    EXPECT_TRUE(build(solid, elasticMaterial(), galerkin_gmls).report().warnings.empty());
    EXPECT_FALSE(build(solid, elasticMaterial(), galerkin_mls).report().warnings.empty());
}

}  // namespace
}  // namespace sherd::validation::bending_rod
