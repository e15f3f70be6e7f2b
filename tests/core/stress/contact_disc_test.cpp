#include "core/stress/contact_disc.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics/pi.h"
#include "core/stress/elasticity.h"

namespace sherd {
namespace {

constexpr double nu = 0.3;

/// Displacement times 4 pi G at x under a force on the half-space z > 0 (Boussinesq and Cerruti; Johnson,
/// Contact Mechanics, 3.2 and 3.6).
Vec3 underPointForce(const Vec3& x, const Vec3& force) {
    const double rho = x.norm(), cubed = rho * rho * rho, sum = rho + x.z();
    const Vec3 flat(x.x(), x.y(), 0), push(force.x(), force.y(), 0);
    Vec3 u = force.z() * (x.z() / cubed - (1 - 2 * nu) / (rho * sum)) * flat;
    u.z() += force.z() * (x.z() * x.z() / cubed + 2 * (1 - nu) / rho);
    u += push / rho + push.dot(flat) * flat / cubed +
         (1 - 2 * nu) * (push / sum - push.dot(flat) * flat / (rho * sum * sum));
    u.z() += push.dot(flat) * (x.z() / cubed + (1 - 2 * nu) / (rho * sum));
    return u;
}

/// The same under a disc of radius 1 about the origin, its point forces summed up: midpoints in the angle and
/// in w = (1 - r^2)^(5/2), in which all rings carry the same.
Vec3 underDisc(const Vec3& x, const Vec3& traction) {
    constexpr int rings = 300, angles = 200;
    Vec3 u = Vec3::Zero();
    for (int i = 0; i < rings; ++i) {
        const double r = std::sqrt(1 - std::pow((i + 0.5) / rings, 0.4));
        for (int j = 0; j < angles; ++j) {
            const double angle = 2 * pi * (j + 0.5) / angles;
            u += underPointForce(x - r * Vec3(std::cos(angle), std::sin(angle), 0), traction);
        }
    }
    return 2 * pi / 5 / (rings * angles) * u;
}

Mat3 summedStress(const Vec3& x, const Vec3& traction) {
    constexpr double step = 1e-4;
    Mat3 g;
    for (int d = 0; d < 3; ++d)
        g.col(d) =
            (underDisc(x + step * Vec3::Unit(d), traction) - underDisc(x - step * Vec3::Unit(d), traction)) /
            (2 * step);
    return (2 * nu / (1 - 2 * nu) * g.trace() * Mat3::Identity() + g + g.transpose()) / (4 * pi);
}

ContactDisc unitDisc(const Vec3& traction) {
    return {Vec3::Zero(), Vec3::UnitZ(), 1, traction};
}

TEST(ContactDisc, IsTheSumOfItsPointForces) {
    for (const Vec3& traction : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.3, -0.7, 0.4)}) {
        const DiscField field(unitDisc(traction), nu);
        for (const Vec3& x : {Vec3(0, 0, 0.7), Vec3(0.3, 0.2, 0.5), Vec3(0.9, -0.5, 0.3), Vec3(-2, 1, 0.2),
                              Vec3(3, 4, 5), Vec3(20, -10, 8)}) {
            const Mat3 summed = summedStress(x, traction);
            EXPECT_LT((field.stressAt(x) - summed).norm(), 2e-3 * summed.norm()) << x.transpose();
        }
    }
}

// Three radii away the closed form gives way to that of a point that is a little wide.
TEST(ContactDisc, HardlyJumpsWhereItIsTakenForAPoint) {
    double largest = 0;
    for (const Vec3& traction : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.3, -0.7, 0.4)})
        for (const double poisson_ratio : {0.0, 0.22, 0.4})
            for (int polar = 0; polar <= 18; ++polar)
                for (const double azimuth : {0.1, 0.8, 1.5}) {
                    const DiscField field(unitDisc(traction), poisson_ratio);
                    const double t = polar * pi / 36;
                    const Vec3 way(std::sin(t) * std::cos(azimuth), std::sin(t) * std::sin(azimuth),
                                   std::cos(t));
                    const Mat3 inside = field.stressAt(2.9999 * way), outside = field.stressAt(3.0001 * way);
                    // Where the field of a point is least it is a few percent of that in other directions.
                    const double size = std::max(inside.norm(), 0.2 / 9 * traction.norm());
                    largest = std::max(largest, (outside - inside).norm() / size);
                }
    EXPECT_LT(largest, 0.0125);
}

// Outside of a pressure that is even all round, the surface is pulled as by a point force (Johnson, 3.4): by
// (1 - 2 nu) F / (2 pi r^2), as much across as it is pressed along.
TEST(ContactDisc, OutsideAPressureTheSurfaceIsPulledAsByAPointForce) {
    const DiscField pressed(unitDisc(Vec3::UnitZ()), nu);
    for (const double r : {1.0, 2.0, 19.9, 20.1}) {
        const Mat3 stress = pressed.stressAt(Vec3(0, r, 0));
        const double pulled = (1 - 2 * nu) / (5 * r * r);
        EXPECT_NEAR(stress(1, 1), pulled, 1e-6 * pulled) << r;
        EXPECT_NEAR(stress(0, 0), -pulled, 1e-6 * pulled) << r;
    }
    EXPECT_NEAR(pressed.stressAt(Vec3::Zero())(2, 2), -1, 1e-12);
}

TEST(ContactDisc, IsItsOwnTractionOnThePlaneAndNoneBeside) {
    const ContactDisc disc{Vec3(1, 2, 3), Vec3(2, -1, 2).normalized(), 0.4, Vec3(3, 1, -2)};
    const DiscField field(disc, nu);
    const Vec3 a = disc.inward.unitOrthogonal(), b = disc.inward.cross(a);
    for (const double r : {0.0, 0.1, 0.39, 0.4, 0.41, 3.0})
        for (const double angle : {0.3, 2.0, 4.0}) {
            const Vec3 x = disc.centre + r * (std::cos(angle) * a + std::sin(angle) * b);
            const Vec3 outward_traction = field.stressAt(x) * -disc.inward;
            EXPECT_LT((outward_traction - disc.tractionAt(x)).norm(), 1e-6) << r;
        }
    EXPECT_LT((disc.tractionAt(disc.centre) - disc.traction_pa).norm(), 1e-15);
}

}  // namespace
}  // namespace sherd
