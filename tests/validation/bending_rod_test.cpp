#include "validation/closed_form.h"

namespace sherd::validation {
namespace {

constexpr double length = 1, side = 0.1, force = 1000;

/// Relative L2 error of the bending stress of a free rod struck in its middle, over the surface points of its
/// halves. Inertia loads it by F/L a length, so that M = F s^2 / (2 L), s from the nearer end, and sigma = M
/// z / I, I = a^4/12.
double bendingError(const StressSettings& settings, double spacing, const Mat3& tilt) {
    const auto solid = sampledForSplines(shapes::moved(shapes::slab({length, side, side}, 20, 2, 2), tilt),
                                         spacing, Basis::quadratic);
    const auto loads =
        spreadOverSurface(*solid, tilt * Vec3(0, 0, -force), [&](const Vec3& x, const Vec3& normal) {
            return (tilt.transpose() * normal).z() > 0.9 && std::abs((tilt.transpose() * x).x()) < side / 2;
        });
    const StressField field = valueOf(build(solid, elasticMaterial(), settings).solve(loads));
    double error = 0, norm = 0;
    for (size_t i = 0; i < solid->surface_points.size(); ++i) {
        const Vec3 x = tilt.transpose() * solid->surface_points[i].position;
        const double from_end = length / 2 - std::abs(x.x());
        if (from_end < side || from_end > 0.4 * length) continue;
        const double moment = -force * from_end * from_end / (2 * length);
        const double expected = moment * x.z() * 12 / std::pow(side, 4);
        const double found = (tilt.transpose() * toMatrix(field.surface[i]) * tilt)(0, 0);
        error += std::pow(found - expected, 2);
        norm += expected * expected;
    }
    return std::sqrt(error / norm);
}

TEST(BendingRod, SplinesAreAccurateWithOneParticleAcrossAtAnyTilt) {
    for (double angle : {0.0, 0.2, 0.5, 0.8}) {
        const Mat3 tilt = (Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized())).toRotationMatrix();
        EXPECT_LT(bendingError(splines(Basis::quadratic), side, tilt), 0.06) << "tilt " << angle;
        EXPECT_LT(bendingError(splines(Basis::quadratic), side / 2, tilt), 0.03) << "tilt " << angle;
    }
}

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
}  // namespace sherd::validation
