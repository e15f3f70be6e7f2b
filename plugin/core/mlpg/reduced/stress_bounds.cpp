#include "core/mlpg/reduced/stress_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/monomials.h"
#include "core/mlpg/splines/volumetric_projection.h"
#include "core/numerics/wide_vectors.h"
#include "core/stress/principal_bound.h"

namespace sherd {

namespace {

constexpr int lane_count = 16;  // parts whose bounds are made side by side
using Lane = float[lane_count];

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

StressBounds::StressBounds(const CellParts& solid, int degree, const Elasticity& elasticity,
                           const std::vector<GridPoint>& samples)
    : width_(degree + 1),
      pieces_(splinePowers(degree)),
      lambda_pa_(static_cast<float>(elasticity.lambda_pa)),
      mu_pa_(static_cast<float>(elasticity.mu_pa)),
      coupling_(lambda_pa_ / (lambda_pa_ + 2 * mu_pa_)),
      projected_share_(static_cast<float>(projectedShare(elasticity))) {
    const auto in_the_middle = [](int n, int i) { return choose(n, i) / std::pow(2, n); };
    for (int k = 0; k <= degree; ++k)
        for (int l = 0; l <= degree; ++l)
            for (int i = 0; i < degree; ++i)
                middle_slopes_.push_back(static_cast<float>(
                    in_the_middle(degree, k) * in_the_middle(degree, l) * in_the_middle(degree - 1, i)));

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

/// Parts side by side, each in a lane of its own: what is done to one lane is done to all.
struct StressBounds::Lanes {
    static constexpr int cube = most * most * most;
    Lane coefficients[3][cube];         ///< per component of the displacement
    Lane to_bernstein[3][most * most];  ///< per direction
    Lane per_length[3];
    Lane gradient[3][3], deviation[3][3];  ///< component, direction: in the middle, and from it
};

namespace {

/// To Bernstein coefficients, one direction after the other; each pass turns the directions on by one.
SHERD_WIDE_VECTORS
void toBernstein(int width, const Lane* along_x, const Lane* along_y, const Lane* along_z, Lane* values) {
    constexpr int most = largest_spline_degree + 1;
    const Lane* matrices[3] = {along_x, along_y, along_z};
    Lane other[most * most * most];
    const int square = width * width;
    Lane *from = values, *to = other;
    for (const Lane* m : matrices) {
        for (int line = 0; line < square; ++line)
            for (int i = 0; i < width; ++i) {
                Lane sum = {};
                for (int a = 0; a < width; ++a)
                    for (int l = 0; l < lane_count; ++l)
                        sum[l] += m[i * width + a][l] * from[line * width + a][l];
                for (int l = 0; l < lane_count; ++l) to[i * square + line][l] = sum[l];
            }
        std::swap(from, to);
    }
    std::memcpy(values, other,
                sizeof(Lane) * static_cast<std::size_t>(square * width));  // after three passes
}

/// The slope of Bernstein coefficients in the middle, along a direction in which neighbours are `step` apart,
/// and how far it may be from that elsewhere.
SHERD_WIDE_VECTORS
void slopeOf(int width, const Lane* values, int step, int second, int third, const float* weights,
             const Lane& per_length, Lane& slope, Lane& deviation) {
    constexpr int most = largest_spline_degree + 1;
    Lane differences[most * most * most];
    Lane middle = {}, largest = {};
    int n = 0;
    for (int k = 0; k < width; ++k)
        for (int j = 0; j < width; ++j)
            for (int i = 0; i + 1 < width; ++i, ++n) {
                const Lane* at = values + i * step + k * second + j * third;
                for (int l = 0; l < lane_count; ++l) {
                    differences[n][l] = at[step][l] - at[0][l];
                    middle[l] += weights[n] * differences[n][l];
                }
            }
    for (int m = 0; m < n; ++m)
        for (int l = 0; l < lane_count; ++l) {
            const float off = std::fabs(differences[m][l] - middle[l]);
            largest[l] = largest[l] < off ? off : largest[l];
        }
    for (int l = 0; l < lane_count; ++l) {
        slope[l] = per_length[l] * middle[l];
        deviation[l] = per_length[l] * largest[l];
    }
}

SHERD_WIDE_VECTORS
void rangesOf(const GradientLanes& points, float lambda, float mu, float coupling,
              const GradientLanes::Lane& may_be_freed, StressBounds::RangeLanes& ranges) {
    constexpr float rounding = 1e-4f;
    const auto& g = points.gradient;
    for (int l = 0; l < GradientLanes::count; ++l) {
        const float equal = lambda * (g[0][0][l] + g[1][1][l] + g[2][2][l]);
        float smallest, largest;
        boundPrincipal(equal + 2 * mu * g[0][0][l], equal + 2 * mu * g[1][1][l], equal + 2 * mu * g[2][2][l],
                       mu * (g[0][1][l] + g[1][0][l]), mu * (g[1][2][l] + g[2][1][l]),
                       mu * (g[2][0][l] + g[0][2][l]), rounding, smallest, largest);
        const float freed = coupling * may_be_freed[l];
        ranges.smallest[l] = smallest - freed * largest;
        ranges.largest[l] = largest - freed * smallest;
    }
}

}  // namespace

void StressBounds::rangesAt(const GradientLanes& points, const GradientLanes::Lane& may_be_freed,
                            RangeLanes& ranges) const {
    rangesOf(points, lambda_pa_, mu_pa_, coupling_, may_be_freed, ranges);
}

void StressBounds::load(const Eigen::Matrix4Xf& raw, const std::vector<int>& functions, int part, int lane,
                        Lanes& lanes) const {
    for (std::size_t f = 0; f < functions.size(); ++f)
        for (int c = 0; c < 3; ++c) lanes.coefficients[c][f][lane] = raw(c, functions[f]);
    for (int d = 0; d < 3; ++d) {
        const Interval& interval = boxes_[part][d];
        for (int i = 0; i < width_ * width_; ++i) lanes.to_bernstein[d][i][lane] = interval.coefficients[i];
        lanes.per_length[d][lane] = interval.per_length;
    }
}

PrincipalRange StressBounds::range(const Lanes& lanes, int lane) const {
    Eigen::Matrix3f gradient;
    float squared = 0, trace = 0;  // of the deviation of the strain
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            gradient(i, j) = lanes.gradient[i][j][lane];
            const float deviation = 0.5f * (lanes.deviation[i][j][lane] + lanes.deviation[j][i][lane]);
            squared += deviation * deviation;
            if (i == j) trace += deviation;
        }
    // No principal value of a deviation is more than its norm.
    const float spread = lambda_pa_ * trace + 2 * mu_pa_ * std::sqrt(squared);
    return principalRange(stressOf(gradient), spread, coupling_);
}

/// The same with another volumetric strain: a polynomial of xi, which lies in the box by half its width at
/// most from the middle.
PrincipalRange StressBounds::projectedRange(const Lanes& lanes, int lane, const std::array<Interval, 3>& box,
                                            const Eigen::VectorXf& dilatation) const {
    Eigen::Vector3f middle, half;
    for (int d = 0; d < 3; ++d) {
        // Splines reproduce xi, so its Bernstein coefficients at the ends are the ends.
        float ends[2] = {0, 0};
        for (int a = 0; a < width_; ++a) {
            const float greville = static_cast<float>(a) - 0.5f * static_cast<float>(width_ - 1);
            ends[0] += greville * box[d].coefficients[a];
            ends[1] += greville * box[d].coefficients[(width_ - 1) * width_ + a];
        }
        middle[d] = (ends[0] + ends[1]) / 2;
        half[d] = (ends[1] - ends[0]) / 2;
    }
    const Eigen::Vector3f size = middle.cwiseAbs() + half;
    // |m(xi) - m(middle)| of a monomial is at most m(|middle| + half) - m(|middle|).
    const int of_dilatation = dilatationDegree(width_ - 1);
    const Eigen::VectorXf sizes = dilatation.cwiseAbs();
    const float change = polynomialAt(of_dilatation, sizes, size) -
                         polynomialAt(of_dilatation, sizes, Eigen::Vector3f(middle.cwiseAbs()));

    Eigen::Matrix3f gradient;
    float squared = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            gradient(i, j) = lanes.gradient[i][j][lane];
            const float deviation = 0.5f * (lanes.deviation[i][j][lane] + lanes.deviation[j][i][lane]);
            squared += deviation * deviation;
        }
    projectTrace(gradient, polynomialAt(of_dilatation, dilatation, middle), projected_share_);
    return principalRange(stressOf(gradient), lambda_pa_ * change + 2 * mu_pa_ * std::sqrt(squared),
                          coupling_);
}

std::vector<PrincipalRange> StressBounds::ranges(const Eigen::Matrix4Xf& raw,
                                                 const std::vector<std::vector<int>>& functions,
                                                 const Eigen::MatrixXf& dilatation) const {
    const int part_count = static_cast<int>(functions.size());
    std::vector<PrincipalRange> ranges;
    ranges.reserve(functions.size());
    Lanes lanes{};
    const int strides[3] = {1, width_, width_ * width_};
    for (int first = 0; first < part_count; first += lane_count) {
        const int count = std::min(lane_count, part_count - first);
        for (int lane = 0; lane < count; ++lane)
            load(raw, functions[first + lane], first + lane, lane, lanes);
        for (int c = 0; c < 3; ++c) {
            toBernstein(width_, lanes.to_bernstein[0], lanes.to_bernstein[1], lanes.to_bernstein[2],
                        lanes.coefficients[c]);
            for (int d = 0; d < 3; ++d)
                slopeOf(width_, lanes.coefficients[c], strides[d], strides[(d + 1) % 3], strides[(d + 2) % 3],
                        middle_slopes_.data(), lanes.per_length[d], lanes.gradient[c][d],
                        lanes.deviation[c][d]);
        }
        for (int lane = 0; lane < count; ++lane)
            ranges.push_back(dilatation.size() == 0 ? range(lanes, lane)
                                                    : projectedRange(lanes, lane, boxes_[first + lane],
                                                                     dilatation.col(first + lane)));
    }
    return ranges;
}

}  // namespace sherd
