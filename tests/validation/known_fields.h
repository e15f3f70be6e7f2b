#pragma once

#include "validation/closed_form.h"

/// Elastic fields in closed form, and the bodies they are used in.
namespace sherd::validation {

/// In a cylinder frame about z: radial, hoop, and nothing along z.
inline Mat3 cylindrical(const Vec3& x, double radial, double hoop) {
    const Vec3 e = Vec3(x.x(), x.y(), 0).normalized(), t = Vec3::UnitZ().cross(e);
    return radial * e * e.transpose() + hoop * t * t.transpose();
}

/// Plane strain in x-z: what keeps y from stretching is added.
inline Mat3 planeStrain(double xx, double zz, double xz, double nu) {
    Mat3 stress = Mat3::Zero();
    stress(0, 0) = xx;
    stress(2, 2) = zz;
    stress(0, 2) = stress(2, 0) = xz;
    stress(1, 1) = nu * (xx + zz);
    return stress;
}

/// Lame: sigma_r, sigma_theta = A -+ B / r^2 with A = p a^2 / (b^2 - a^2), B = A b^2. Open ends.
inline ClosedForm thickCylinder() {
    const double a = 0.1, b = 0.2, pressure = 1e6;
    const double first = pressure * a * a / (b * b - a * a), second = first * b * b;
    return {shapes::tube(b, a, 0.15, 48), elasticMaterial(5e9, 0.43), [=](const Vec3& x) {
                const double squared = x.head<2>().squaredNorm();
                return cylindrical(x, first - second / squared, first + second / squared);
            }};
}

/// Lame: sigma_r = A (1 - b^3 / r^3), sigma_t = A (1 + b^3 / (2 r^3)), A = p a^3 / (b^3 - a^3).
inline ClosedForm hollowSphere() {
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
inline ClosedForm cantilever() {
    const double length = 1, height = 0.25, force = 1e4;
    const double inertia = std::pow(height, 3) / 12, nu = 0.3;
    return {shapes::box({0, -0.1, -height / 2}, {length, 0.1, height / 2}), elasticMaterial(5e9, nu),
            [=](const Vec3& x) {
                return planeStrain(-force * (length - x.x()) * x.z() / inertia, 0,
                                   force * (height * height / 4 - x.z() * x.z()) / (2 * inertia), nu);
            }};
}

/// Airy's function cos(kx) f(z), f = C sinh kz + D kz cosh kz, with C such that no shear acts on the two
/// sides: a free rod of one wave length, bent by normal loads that add up to nothing (Timoshenko and Goodier,
/// section 24).
inline ClosedForm wavyRod() {
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

/// sigma = diag(m_x, m_y, 0) z: a plate of constant curvatures.
inline ClosedForm curvedPlate(double poisson_ratio, double thickness) {
    return {shapes::slab({1, 0.7, thickness}), elasticMaterial(5e9, poisson_ratio),
            [](const Vec3& x) { return Mat3(Vec3(2e6, -1e6, 0).asDiagonal() * Mat3::Identity() * x.z()); }};
}

/// u = grad F / (2 mu) with F = cos(ax) cos(by) sinh(cz), c^2 = a^2 + b^2, is harmonic: sigma = Hessian of F.
/// Odd in z, so a plate that is bent both ways.
inline ClosedForm bentPlate(double poisson_ratio = 0.43, double width = 1) {
    const double a = 3, b = 4, c = 5;
    return {shapes::slab({width, width, 0.12}), elasticMaterial(5e9, poisson_ratio), [=](const Vec3& x) {
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

}  // namespace sherd::validation
