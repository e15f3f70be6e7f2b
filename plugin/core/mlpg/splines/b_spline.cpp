#include "core/mlpg/splines/b_spline.h"

#include <sherd/settings.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

namespace sherd {
namespace {

using Pieces = std::array<double, largest_spline_degree + 1>;

/// The pieces at t in [-1/2, 1/2] from the middle of a cell, and their slopes.
void pieces(int degree, double t, Pieces& value, Pieces& slope) {
    const double s = t + 0.5, r = 1 - s;
    switch (degree) {
        case 1:
            value = {r, s};
            slope = {-1, 1};
            break;
        case 2:
            value = {r * r / 2, 0.5 + s * r, s * s / 2};
            slope = {-r, r - s, s};
            break;
        default:
            value = {r * r * r / 6, (3 * s * s * s - 6 * s * s + 4) / 6, (3 * r * r * r - 6 * r * r + 4) / 6,
                     s * s * s / 6};
            slope = {-r * r / 2, (3 * s * s - 4 * s) / 2, (4 * r - 3 * r * r) / 2, s * s / 2};
    }
}

}  // namespace

void splineValues(int degree, const Vec3& xi, std::vector<double>& values) {
    std::array<Pieces, 3> value, slope;
    for (int d = 0; d < 3; ++d) pieces(degree, xi[d], value[d], slope[d]);
    const int count = degree + 1;
    values.resize(static_cast<std::size_t>(count * count * count));
    double* next = values.data();
    for (int k = 0; k < count; ++k)
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < count; ++i) *next++ = value[0][i] * value[1][j] * value[2][k];
}

void splineGradients(int degree, const Vec3& xi, std::vector<Vec3>& gradients) {
    std::array<Pieces, 3> value, slope;
    for (int d = 0; d < 3; ++d) pieces(degree, xi[d], value[d], slope[d]);
    gradients.clear();
    for (int k = 0; k <= degree; ++k)
        for (int j = 0; j <= degree; ++j)
            for (int i = 0; i <= degree; ++i)
                gradients.emplace_back(slope[0][i] * value[1][j] * value[2][k],
                                       value[0][i] * slope[1][j] * value[2][k],
                                       value[0][i] * value[1][j] * slope[2][k]);
}

Eigen::MatrixXd splinePowers(int degree) {
    Eigen::MatrixXd at(degree + 1, degree + 1), vandermonde(degree + 1, degree + 1);
    for (int q = 0; q <= degree; ++q) {
        const double t = q / static_cast<double>(degree) - 0.5;
        Pieces value, slope;
        pieces(degree, t, value, slope);
        for (int a = 0; a <= degree; ++a) at(q, a) = value[a];
        for (int k = 0; k <= degree; ++k) vandermonde(q, k) = std::pow(t, k);
    }
    return vandermonde.inverse() * at;
}

}  // namespace sherd
