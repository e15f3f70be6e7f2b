#include "core/mlpg/reduced/stress_bounds.h"

#include <algorithm>
#include <cmath>

#include "core/mlpg/splines/b_spline.h"

namespace sherd {

namespace {

using Quad = Eigen::Array4f;  // one register: a vector and a zero

double choose(int n, int k) {
    double value = 1;
    for (int i = 0; i < k; ++i) value *= static_cast<double>(n - i) / (i + 1);
    return value;
}

/// The polar form of x^power for `degree` arguments of which `high` are `to` and the others `from`: the mean
/// of the products of `power` of them.
double polarForm(int degree, int power, int high, double from, double to) {
    double sum = 0;
    for (int of_high = 0; of_high <= power; ++of_high)
        sum += choose(high, of_high) * choose(degree - high, power - of_high) * std::pow(to, of_high) *
               std::pow(from, power - of_high);
    return sum / choose(degree, power);
}

}  // namespace

PrincipalRange principalRange(const Eigen::Matrix3f& stress, float spread, float coupling) {
    constexpr float rounding = 1e-4f;
    const float mean = stress.trace() / 3;
    const float deviator = std::sqrt(2.0f / 3) * (stress - mean * Eigen::Matrix3f::Identity()).norm();
    const float slack = spread + rounding * stress.norm();
    const float largest = std::max(0.0f, mean + deviator + slack);
    const float smallest = std::min(0.0f, mean - deviator - slack);
    return {smallest - coupling * largest, largest - coupling * smallest};
}

StressBounds::StressBounds(const CellParts& solid, int degree, const Elasticity& elasticity,
                           const std::vector<GridPoint>& samples)
    : width_(degree + 1),
      pieces_(splinePowers(degree)),
      lambda_pa_(static_cast<float>(elasticity.lambda_pa)),
      mu_pa_(static_cast<float>(elasticity.mu_pa)),
      coupling_(lambda_pa_ / (lambda_pa_ + 2 * mu_pa_)) {
    for (int i = 0; i <= degree; ++i)
        middle_.push_back(static_cast<float>(choose(degree, i) / std::pow(2, degree)));
    for (int i = 0; i < degree; ++i)
        middle_slopes_.push_back(static_cast<float>(choose(degree - 1, i) / std::pow(2, degree - 1)));

    std::vector<Eigen::AlignedBox3d> held(solid.parts.size());
    for (const GridPoint& sample : samples)
        if (sample.part >= 0) held[sample.part].extend(sample.xi);
    constexpr double least_width = 1e-2;  // in edges: of a part with a single sample
    for (const Eigen::AlignedBox3d& box : held) {
        boxes_.emplace_back();
        if (box.isEmpty()) continue;
        for (int d = 0; d < 3; ++d)
            boxes_.back()[d] =
                intervalOf(box.min()[d] - least_width, box.max()[d] + least_width, solid.edges[d]);
    }
}

StressBounds::Interval StressBounds::intervalOf(double from, double to, double edge) const {
    const int degree = width_ - 1;
    Interval interval;
    for (int i = 0; i < width_; ++i)
        for (int a = 0; a < width_; ++a) {
            double value = 0;
            for (int power = 0; power <= degree; ++power)
                value += pieces_(power, a) * polarForm(degree, power, i, from, to);
            interval.coefficients[i * width_ + a] = static_cast<float>(value);
        }
    interval.per_length = static_cast<float>(degree / ((to - from) * edge));
    return interval;
}

PrincipalRange StressBounds::range(const Eigen::Matrix4Xf& raw, const std::vector<int>& functions,
                                   int part) const {
    constexpr int cube = most * most * most;
    const int w = width_, count = w * w * w;
    Quad own[cube], other[cube];
    for (int a = 0; a < count; ++a) own[a] = raw.col(functions[a]).array();
    // To Bernstein coefficients, one direction after the other; each pass turns the directions on by one.
    for (int d = 0; d < 3; ++d) {
        const float* m = boxes_[part][d].coefficients.data();
        for (int line = 0; line < w * w; ++line)
            for (int i = 0; i < w; ++i) {
                Quad sum = m[i * w] * own[line * w];
                for (int a = 1; a < w; ++a) sum += m[i * w + a] * own[line * w + a];
                other[i * w * w + line] = sum;
            }
        std::copy(other, other + count, own);
    }
    const int strides[3] = {1, w, w * w};
    Quad columns[3], deviations[3];
    for (int j = 0; j < 3; ++j) {
        const int s = strides[j], t = strides[(j + 1) % 3], u = strides[(j + 2) % 3];
        const float per_length = boxes_[part][j].per_length;
        Quad slopes[cube];
        Quad middle = Quad::Zero();
        int n = 0;
        for (int k = 0; k < w; ++k)
            for (int l = 0; l < w; ++l)
                for (int i = 0; i + 1 < w; ++i) {
                    const Quad* at = own + i * s + k * t + l * u;
                    slopes[n] = at[s] - at[0];
                    middle += middle_slopes_[i] * middle_[k] * middle_[l] * slopes[n++];
                }
        Quad deviation = Quad::Zero();
        for (int k = 0; k < n; ++k) deviation = deviation.max((slopes[k] - middle).abs());
        columns[j] = per_length * middle;
        deviations[j] = per_length * deviation;
    }

    Eigen::Matrix3f strain;
    float squared = 0, trace = 0;  // of the deviation of the strain
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            strain(i, j) = 0.5f * (columns[j][i] + columns[i][j]);
            const float deviation = 0.5f * (deviations[j][i] + deviations[i][j]);
            squared += deviation * deviation;
            if (i == j) trace += deviation;
        }
    // No principal value of a deviation is more than its norm.
    const float spread = lambda_pa_ * trace + 2 * mu_pa_ * std::sqrt(squared);
    const Eigen::Matrix3f stress =
        lambda_pa_ * strain.trace() * Eigen::Matrix3f::Identity() + 2 * mu_pa_ * strain;
    return principalRange(stress, spread, coupling_);
}

}  // namespace sherd
