#include "core/mlpg/reduced/gradient_lanes.h"

#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

constexpr int lane_count = GradientLanes::count;
using Lane = GradientLanes::Lane;

/// Values of the pieces of the splines along one direction, and their slopes.
template <int width>
SHERD_INLINED void readPieces(const float (*powers)[width], const Lane& at, Lane* values, Lane* slopes) {
    for (int a = 0; a < width; ++a)
        for (int l = 0; l < lane_count; ++l) {
            float value = 0, slope = 0;
            for (int k = width - 1; k >= 0; --k) {
                slope = slope * at[l] + value;
                value = value * at[l] + powers[k][a];
            }
            values[a][l] = value;
            slopes[a][l] = slope;
        }
}

template <int width>
SHERD_INLINED void findGradients(const float (*powers)[width], const PartCoefficients& coefficients,
                                 const float* per_edge, GradientLanes& points) {
    Lane values[3][width], slopes[3][width];
    for (int d = 0; d < 3; ++d) readPieces<width>(powers, points.xi[d], values[d], slopes[d]);
    for (int i = 0; i < 3; ++i) {
        Lane by_x = {}, by_y = {}, by_z = {};
        for (int c = 0; c < width; ++c) {
            Lane plane = {}, plane_x = {}, plane_y = {};
            for (int b = 0; b < width; ++b)
                for (int l = 0; l < lane_count; ++l) {
                    float line = 0, line_x = 0;
                    for (int a = 0; a < width; ++a) {
                        const float own = coefficients.of_function[(c * width + b) * width + a][i];
                        line += values[0][a][l] * own;
                        line_x += slopes[0][a][l] * own;
                    }
                    plane[l] += values[1][b][l] * line;
                    plane_x[l] += values[1][b][l] * line_x;
                    plane_y[l] += slopes[1][b][l] * line;
                }
            for (int l = 0; l < lane_count; ++l) {
                by_x[l] += values[2][c][l] * plane_x[l];
                by_y[l] += values[2][c][l] * plane_y[l];
                by_z[l] += slopes[2][c][l] * plane[l];
            }
        }
        const Lane* const slope[3] = {&by_x, &by_y, &by_z};
        for (int d = 0; d < 3; ++d) {
            const float scale = per_edge[d];
            for (int l = 0; l < lane_count; ++l) points.gradient[i][d][l] = (*slope[d])[l] * scale;
        }
    }
}

SHERD_WIDE_VECTORS
void linear(const float (*powers)[2], const PartCoefficients& own, const float* edges,
            GradientLanes& points) {
    findGradients<2>(powers, own, edges, points);
}

SHERD_WIDE_VECTORS
void quadratic(const float (*powers)[3], const PartCoefficients& own, const float* edges,
               GradientLanes& points) {
    findGradients<3>(powers, own, edges, points);
}

SHERD_WIDE_VECTORS
void cubic(const float (*powers)[4], const PartCoefficients& own, const float* edges, GradientLanes& points) {
    findGradients<4>(powers, own, edges, points);
}

template <int width, class Find>
void findWith(const Find& find, const Eigen::MatrixXf& powers, const PartCoefficients& coefficients,
              const Eigen::Vector3f& per_edge, GradientLanes& points) {
    float by_power[width][width];
    for (int k = 0; k < width; ++k)
        for (int a = 0; a < width; ++a) by_power[k][a] = powers(k, a);
    find(by_power, coefficients, per_edge.data(), points);
}

}  // namespace

void findGradients(int degree, const Eigen::MatrixXf& powers, const PartCoefficients& coefficients,
                   const Eigen::Vector3f& per_edge, GradientLanes& points) {
    switch (degree) {
        case 1:
            return findWith<2>(linear, powers, coefficients, per_edge, points);
        case 2:
            return findWith<3>(quadratic, powers, coefficients, per_edge, points);
        default:
            static_assert(largest_spline_degree == 3);
            return findWith<4>(cubic, powers, coefficients, per_edge, points);
    }
}

}  // namespace sherd
