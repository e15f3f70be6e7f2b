#pragma once

#include <cmath>

#include "core/numerics/wide_vectors.h"
#include "core/stress/contact_disc.h"

// The closed form of the stress under a disc, for one place or for places in lanes: without branches.
namespace sherd::under_disc {

struct Complex {
    double re = 0, im = 0;
};
SHERD_INLINED Complex operator+(Complex a, Complex b) {
    return {a.re + b.re, a.im + b.im};
}
SHERD_INLINED Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
/// Of the upper half-plane, into the first quadrant.
SHERD_INLINED Complex squareRoot(Complex a) {
    const double size = std::sqrt(a.re * a.re + a.im * a.im);
    const double larger = std::sqrt((size + std::abs(a.re)) / 2);
    const double smaller = larger > 0 ? a.im / (2 * larger) : 0;
    const bool is_right = a.re >= 0;
    return {is_right ? larger : smaller, is_right ? smaller : larger};
}
SHERD_INLINED Complex inverse(Complex a) {
    const double squared = a.re * a.re + a.im * a.im;
    return {a.re / squared, -a.im / squared};
}
SHERD_INLINED Complex operator*(double f, Complex a) {
    return {f * a.re, f * a.im};
}

/// Of three terms, as `underDisc` has them.
SHERD_INLINED double sum(Complex third, Complex fourth, Complex fifth) {
    return -15 * third.im - 45 * fourth.re + 45 * fifth.im;
}

/// Harmonic functions of which the fields under a force on a half-space consist (Boussinesq, Cerruti; K. L.
/// Johnson, Contact Mechanics, 3.2): H_0 = 1 / R under a point force, R^2 = s + z^2, s = x^2 + y^2, and
/// H_(k-1) is the derivative of H_k by z. Derivatives by s / 2 are written d, dd, ddd, so that in the plane
/// d_i H = x_i dH, d_i d_j H = delta_ij dH + x_i x_j ddH and so on.
struct Potentials {
    double h_m2, h_m1, d_m1;  // H_-2, H_-1
    double d_0, dd_0;
    double d_1, dd_1, ddd_1;
    double dd_2, ddd_2;
};

/// Those under a force of 1 on a disc of radius 1 with the profile of a contact: point sources at imaginary
/// depths,
///     H_k = 15/16 int (1 - t^2)^2 h_k(s, z + i t) dt, t = -1 .. 1,
///         = -15 Im h_(k+3) - 45 Re h_(k+4) + 45 Im h_(k+5) at (s, z + i),
/// by parts, each h_(k+1) an integral of h_k by zeta = z + i t. With e = 1 / (R + zeta) and L = log(R + zeta)
/// all are powers of e, s and L: the integral of e^n / R is -e^n / n, of 1 / R it is L, R = (1 / e + s e) / 2
/// and zeta = (1 / e - s e) / 2. Of L only the angle is left in the end.
/// That is `angleOf` R + zeta.
template <class AngleOf>
SHERD_INLINED Potentials underDisc(double s, double z, const AngleOf& angleOf) {
    const Complex zeta{z, 1};
    const Complex r = squareRoot({s + z * z - 1, 2 * z});
    const Complex one_over_e = r + zeta, e = inverse(one_over_e), e2 = e * e;
    const Complex u = s * e2;  // all below are a power of e times a polynomial in u
    const Complex u2 = u * u, u3 = u2 * u, u4 = u2 * u2, one{1, 0};
    const Complex one_over_e2 = one_over_e * one_over_e, e3 = e2 * e;
    const double angle = angleOf(one_over_e);
    // Without their terms with L, which follow in `sum`s as multiples of the angle.
    const Complex zeta_r = zeta * r;
    const Complex h_4 = (-11.0 / 36) * (r * r * r) + (5.0 / 12 * s) * r;
    const Complex d_3 = (1.0 / 4) * u;
    const Complex d_4 = one_over_e * ((1.0 / 4) * one + (1.0 / 8) * u + (-1.0 / 24) * u2);
    const Complex d_5 = one_over_e2 * ((3.0 / 32) * one + (-5.0 / 96) * u2 + (1.0 / 192) * u3);
    const Complex d_6 =
        one_over_e2 * one_over_e *
        ((11.0 / 576) * one + (-1.0 / 64) * u + (-7.0 / 192) * u2 + (13.0 / 1152) * u3 + (-1.0 / 1920) * u4);
    const Complex dd_3 = (-1.0 / 2) * e2;
    const Complex dd_4 = e * ((1.0 / 4) * one + (1.0 / 12) * u);
    const Complex dd_5 = (-1.0 / 12) * u + (-1.0 / 96) * u2;
    const Complex dd_6 =
        one_over_e * ((-1.0 / 16) * one + (-1.0 / 48) * u + (1.0 / 64) * u2 + (1.0 / 960) * u3);
    const Complex dd_7 =
        one_over_e2 * ((-3.0 / 128) * one + (7.0 / 768) * u2 + (-1.0 / 480) * u3 + (-1.0 / 11520) * u4);
    const Complex ddd_4 = (-1.0 / 3) * e3;
    const Complex ddd_5 = e2 * ((1.0 / 12) * one + (1.0 / 24) * u);
    const Complex ddd_6 = e * ((-1.0 / 24) * one + (-1.0 / 48) * u + (-1.0 / 240) * u2);
    const Complex ddd_7 = (1.0 / 64) * u + (1.0 / 320) * u2 + (1.0 / 2880) * u3;

    const Complex none{0, 0}, minus_r = -1.0 * r, h_3 = (-3.0 / 4) * zeta_r;
    const double z2 = z * z;
    Potentials p;
    p.h_m2 = sum(none, minus_r, h_3) + (15.0 / 2 + 45.0 / 2 * z2 - 45.0 / 4 * s) * angle;
    p.h_m1 = sum(minus_r, h_3, h_4) + (15.0 / 2 * (1 + z2) - 45.0 / 4 * s) * z * angle;
    p.d_m1 = sum(-1.0 * e, d_3, d_4) - 45.0 / 2 * z * angle;
    p.d_0 = sum(d_3, d_4, d_5) + (-15.0 / 4 - 45.0 / 4 * z2 + 45.0 / 16 * s) * angle;
    p.dd_0 = sum(dd_3, dd_4, dd_5) + 45.0 / 8 * angle;
    p.d_1 = sum(d_4, d_5, d_6) + (-15.0 / 4 * (1 + z2) + 45.0 / 16 * s) * z * angle;
    p.dd_1 = sum(dd_4, dd_5, dd_6) + 45.0 / 8 * z * angle;
    p.ddd_1 = sum(ddd_4, ddd_5, ddd_6);
    p.dd_2 = sum(dd_5, dd_6, dd_7) + (15.0 / 16 + 45.0 / 16 * z2 - 15.0 / 32 * s) * angle;
    p.ddd_2 = sum(ddd_5, ddd_6, ddd_7) - 15.0 / 16 * angle;
    return p;
}

/// The same far away. There a disc is a point force, and a second term for its width, which follows from
/// <r^2> = 2/7, and from h_k being harmonic: H_k = h_k + <r^2> / 4 (d_x^2 + d_y^2) h_k = h_k - h_(k-2) / 14.
SHERD_INLINED Potentials underFarDisc(double s, double z) {
    constexpr double width = 1.0 / 14;
    const double r = std::sqrt(s + z * z), inverse = 1 / (r * (r + z));  // one division for both
    const double q = inverse * (r + z), e = inverse * r;                 // 1 / r, 1 / (r + z)
    const double q2 = q * q;                                             // de = -e^2 q, dq = -q^3
    const double e2 = e * e, q3 = q2 * q, q5 = q3 * q2, q7 = q5 * q2, q9 = q7 * q2, z2 = z * z;
    const double h_m2 = 3 * z2 * q5 - q3, h_m1 = -z * q3, d_m1 = 3 * z * q5, d_0 = -q3, dd_0 = 3 * q5;
    Potentials p;
    p.h_m2 = h_m2 - width * (9 * q5 - 90 * z2 * q7 + 105 * z2 * z2 * q9);
    p.h_m1 = h_m1 - width * (9 * z * q5 - 15 * z * z2 * q7);
    p.d_m1 = d_m1 - width * (105 * z * z2 * q9 - 45 * z * q7);
    p.d_0 = d_0 - width * (3 * q5 - 15 * z2 * q7);
    p.dd_0 = dd_0 - width * (105 * z2 * q9 - 15 * q7);
    p.d_1 = e * q - width * d_m1;
    p.dd_1 = -e2 * q2 - e * q3 + width * 15 * z * q7;
    p.ddd_1 = 2 * e2 * e * q3 + 3 * e2 * q2 * q2 + 3 * e * q5 - width * 105 * z * q9;
    p.dd_2 = e2 * q - width * dd_0;
    p.ddd_2 = -2 * e2 * e * q2 - e2 * q3 + width * 15 * q7;
    return p;
}

/// From there on a disc is taken for a point that is a little wide, to 1.2 % of a point's stress there, 5e-4
/// of the traction (tests/core/stress/contact_disc_test). Much farther out the closed form loses digits.
constexpr double far = 3;  // radii

/// Stress behind the plane on the disc's own axes, lengths in radii.
struct LocalStress {
    double xx, yy, zz, xy, yz, zx;
};

SHERD_INLINED LocalStress stressUnder(const Potentials& h, const DiscField::Traction& of, double x, double y,
                                      double z) {
    // Gradient of 4 pi G u, u being the displacement: Johnson's Eq. 3.7, term by term.
    const double p = of.inward_pa, q = of.along_pa, nu = of.nu;
    const double normal_1 = -p * (1 - 2 * nu) * h.d_1 - p * z * h.d_0;
    const double normal_2 = -p * (1 - 2 * nu) * h.dd_1 - p * z * h.dd_0;
    const double once = q * (2 * nu * h.dd_2 - z * h.dd_1), thrice = q * (2 * nu * h.ddd_2 - z * h.ddd_1);
    const double g_xx = normal_1 + x * x * normal_2 + 2 * q * x * h.d_0 + 3 * x * once + x * x * x * thrice;
    const double g_yy = normal_1 + y * y * normal_2 + x * once + x * y * y * thrice;
    const double g_xy = x * y * normal_2 + 2 * q * y * h.d_0 + y * once + x * x * y * thrice;
    const double g_yx = x * y * normal_2 + y * once + x * x * y * thrice;
    const double radial_z = p * (-2 * (1 - nu) * h.d_0 - z * h.d_m1);  // d_z u_i = x_i of it
    const double z_radial = p * (2 * (1 - nu) * h.d_0 - z * h.d_m1);   // d_i u_z = x_i of it
    const double shear_1 = q * (-(1 - 2 * nu) * h.d_1 - z * h.d_0);
    const double shear_2 = q * (-(1 - 2 * nu) * h.dd_1 - z * h.dd_0);
    const double g_xz = x * radial_z + 2 * q * h.h_m1 + shear_1 + x * x * shear_2;
    const double g_yz = y * radial_z + x * y * shear_2;
    const double lift_1 = q * ((1 - 2 * nu) * h.d_1 - z * h.d_0);
    const double lift_2 = q * ((1 - 2 * nu) * h.dd_1 - z * h.dd_0);
    const double g_zx = x * z_radial + lift_1 + x * x * lift_2;
    const double g_zy = y * z_radial + x * y * lift_2;
    const double g_zz = p * ((1 - 2 * nu) * h.h_m1 - z * h.h_m2) + q * x * (-2 * nu * h.d_0 - z * h.d_m1);
    // sigma = (2 nu / (1 - 2 nu) tr(g) + g + g^T) F / (4 pi), F = 2 pi / 5 of the traction in the middle.
    const double equal = 2 * nu / (1 - 2 * nu) * (g_xx + (g_yy + g_zz));
    return {0.1 * (equal + g_xx + g_xx), 0.1 * (equal + g_yy + g_yy), 0.1 * (equal + g_zz + g_zz),
            0.1 * (g_xy + g_yx),         0.1 * (g_yz + g_zy),         0.1 * (g_zx + g_xz)};
}

/// Radii before the plane up to which a place is on it.
constexpr double on_plane = 1e-6;
/// How steeply a place may lie before the plane until the field says nothing of it, and begins to fade.
constexpr double too_steep = 0.8, steep = 0.4;
SHERD_INLINED double shareBefore(double steepness) {
    const double share = (too_steep - steepness) / (too_steep - steep);
    const double positive = share > 0 ? share : 0;
    return positive < 1 ? positive : 1;
}

}  // namespace sherd::under_disc
