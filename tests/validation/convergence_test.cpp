#include "validation/closed_form.h"

namespace sherd::validation {
namespace {

/// In a cylinder frame about z: radial, hoop, and nothing along z.
Mat3 cylindrical(const Vec3& x, double radial, double hoop) {
    const Vec3 e = Vec3(x.x(), x.y(), 0).normalized(), t = Vec3::UnitZ().cross(e);
    return radial * e * e.transpose() + hoop * t * t.transpose();
}

/// Plane strain in x-z: what keeps y from stretching is added.
Mat3 planeStrain(double xx, double zz, double xz, double nu) {
    Mat3 stress = Mat3::Zero();
    stress(0, 0) = xx;
    stress(2, 2) = zz;
    stress(0, 2) = stress(2, 0) = xz;
    stress(1, 1) = nu * (xx + zz);
    return stress;
}

/// Lame: sigma_r, sigma_theta = A -+ B / r^2 with A = p a^2 / (b^2 - a^2), B = A b^2. Open ends.
ClosedForm thickCylinder() {
    const double a = 0.1, b = 0.2, pressure = 1e6;
    const double first = pressure * a * a / (b * b - a * a), second = first * b * b;
    return {shapes::tube(b, a, 0.15, 48), elasticMaterial(5e9, 0.43), [=](const Vec3& x) {
                const double squared = x.head<2>().squaredNorm();
                return cylindrical(x, first - second / squared, first + second / squared);
            }};
}

/// Lame: sigma_r = A (1 - b^3 / r^3), sigma_t = A (1 + b^3 / (2 r^3)), A = p a^3 / (b^3 - a^3).
ClosedForm hollowSphere() {
    const double a = 0.5, b = 1, pressure = 1e6;
    const double first = pressure * a * a * a / (b * b * b - a * a * a);
    return {shapes::hollowSphere(b, a, 3), elasticMaterial(5e9, 0.3), [=](const Vec3& x) -> Mat3 {
                const Vec3 e = x.normalized();
                const double cubed = std::pow(b / x.norm(), 3);
                const double radial = first * (1 - cubed), hoop = first * (1 + cubed / 2);
                return hoop * Mat3::Identity() + (radial - hoop) * e * e.transpose();
            }};
}

/// Timoshenko: sigma_xx = -P (L - x) z / I, tau_xz = P (h^2 / 4 - z^2) / (2 I), with I = h^3 / 12 a width.
ClosedForm cantilever() {
    const double length = 1, height = 0.25, force = 1e4;
    const double inertia = std::pow(height, 3) / 12, nu = 0.3;
    return {shapes::box({0, -0.1, -height / 2}, {length, 0.1, height / 2}), elasticMaterial(5e9, nu),
            [=](const Vec3& x) {
                return planeStrain(-force * (length - x.x()) * x.z() / inertia, 0,
                                   force * (height * height / 4 - x.z() * x.z()) / (2 * inertia), nu);
            }};
}

/// Airy's function cos(kx) f(z), f = C sinh kz + D kz cosh kz, with C such that no shear acts on the two sides: a free
/// rod of one wave length, bent by normal loads that add up to nothing (Timoshenko and Goodier, section 24).
ClosedForm wavyRod() {
    const double length = 1, side = 0.15, nu = 0.35, k = 2 * std::acos(-1.0) / length;
    const double end = k * side / 2;
    const double d = 1e6, c = -d * (std::cosh(end) + end * std::sinh(end)) / std::cosh(end);
    return {shapes::slab({length, side, side}), elasticMaterial(5e9, nu), [=](const Vec3& x) {
                const double z = k * x.z(), sh = std::sinh(z), ch = std::cosh(z);
                const double f = c * sh + d * z * ch;
                const double first = c * ch + d * (ch + z * sh), second = c * sh + d * (2 * sh + z * ch);
                return planeStrain(second * std::cos(k * x.x()), -f * std::cos(k * x.x()),
                                   first * std::sin(k * x.x()), nu);
            }};
}

/// u = grad F / (2 mu) with F = cos(ax) cos(by) sinh(cz), c^2 = a^2 + b^2, is harmonic: sigma = Hessian of F. Odd in z, so
/// a plate that is bent both ways.
ClosedForm bentPlate() {
    const double a = 3, b = 4, c = 5;
    return {shapes::slab({1, 1, 0.12}), elasticMaterial(5e9, 0.43), [=](const Vec3& x) {
                const double cx = std::cos(a * x.x()), sx = std::sin(a * x.x());
                const double cy = std::cos(b * x.y()), sy = std::sin(b * x.y());
                const double ch = std::cosh(c * x.z()), sh = std::sinh(c * x.z());
                Mat3 hessian;
                hessian << -a * a * cx * cy * sh, a * b * sx * sy * sh, -a * c * sx * cy * ch,  //
                    a * b * sx * sy * sh, -b * b * cx * cy * sh, -b * c * cx * sy * ch,         //
                    -a * c * sx * cy * ch, -b * c * cx * sy * ch, c * c * cx * cy * sh;
                return Mat3(1e6 * hessian);
            }};
}

void expectRates(const ClosedForm& form, const std::array<double, 3>& spacings, Basis basis) {
    const Convergence found = converge(form, spacings, basis);
    EXPECT_GT(found.interior_rate, expectedRate(basis));
    EXPECT_GT(found.surface_rate, expectedRate(basis));
}

TEST(Convergence, ThickCylinder) {
    for (const Basis basis : all_bases) expectRates(thickCylinder(), {0.05, 0.035, 0.025}, basis);
}

TEST(Convergence, HollowSphere) {
    expectRates(hollowSphere(), {0.25, 0.18, 0.125}, Basis::quadratic);
}

TEST(Convergence, Cantilever) {
    for (const Basis basis : {Basis::linear, Basis::quadratic})
        expectRates(turned(cantilever(), someRotation()), {0.125, 0.09, 0.0625}, basis);
}

// Its displacement is cubic, so cubic splines say it exactly, in cut cells as in whole ones; what is left is rounding
// times the condition of functions that were continued over slivers.
TEST(Convergence, CubicSplinesHoldTheCantileverToRounding) {
    EXPECT_LT(errorsOf(turned(cantilever(), someRotation()), 0.1, Basis::cubic).interior, 1e-6);
}

TEST(Convergence, FreeRodAtAnyTilt) {
    for (const double angle : {0.0, 0.2, 0.5, 0.8}) {
        const Mat3 tilt = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
        expectRates(turned(wavyRod(), tilt), {0.075, 0.05, 0.0333}, Basis::quadratic);
    }
}

TEST(Convergence, PlateInBending) {
    for (const Basis basis : {Basis::quadratic, Basis::cubic})
        expectRates(turned(bentPlate(), someRotation()), {0.12, 0.085, 0.06}, basis);
}

// Strains within the surface converge better than the stress across it, which the traction replaces.
TEST(Convergence, TractionsMendTheStressAtTheSurface) {
    for (const ClosedForm& form : {thickCylinder(), turned(bentPlate(), someRotation())}) {
        const double spacing = form.surface.vertices[0].norm() < 0.3 ? 0.035 : 0.085;
        const Errors errors = errorsOf(form, spacing, Basis::quadratic);
        EXPECT_LT(errors.with_traction, 0.6 * errors.surface);
    }
}

}  // namespace
}  // namespace sherd::validation
