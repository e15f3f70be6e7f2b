#include "core/mlpg/splines/part_integrals.h"

#include <sherd/settings.h>

#include <algorithm>
#include <cmath>

#include "core/mlpg/splines/b_spline.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {
namespace {

/// Product of polynomials given by their powers.
Eigen::VectorXd product(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int powers) {
    Eigen::VectorXd c = Eigen::VectorXd::Zero(powers);
    for (long i = 0; i < a.size(); ++i)
        for (long j = 0; j < b.size() && i + j < powers; ++j) c[i + j] += a[i] * b[j];
    return c;
}

// Of products of two splines, in one direction.
constexpr long most_powers = 2 * largest_spline_degree + 1,
               most_pairs = (largest_spline_degree + 1) * (largest_spline_degree + 1);
/// The most numbers that are contracted: the last direction is there by its powers still.
constexpr long largest_array = most_pairs * most_pairs * most_powers;

/// out(r, i) = sum over k of factor(k, i) in(r, k), with r fastest, then k or i.
template <int Terms>
inline __attribute__((always_inline)) void contractLast(const double* factor, long count, const double* in,
                                                        long rest, double* out) {
    for (long i = 0; i < count; ++i, factor += Terms, out += rest)
        for (long r = 0; r < rest; ++r) {
            double sum = factor[0] * in[r];
            for (int k = 1; k < Terms; ++k) sum += factor[k] * in[k * rest + r];
            out[r] = sum;
        }
}

SHERD_WIDE_VECTORS void contractLast3(const double* factor, long count, const double* in, long rest,
                                      double* out) {
    contractLast<3>(factor, count, in, rest, out);
}
SHERD_WIDE_VECTORS void contractLast5(const double* factor, long count, const double* in, long rest,
                                      double* out) {
    contractLast<5>(factor, count, in, rest, out);
}
SHERD_WIDE_VECTORS void contractLast7(const double* factor, long count, const double* in, long rest,
                                      double* out) {
    contractLast<7>(factor, count, in, rest, out);
}

/// Contracts the first index of an array of `size` numbers with the first of `factor` (powers x count), and
/// moves it to the end of `result`. Returns the size of that.
long contractFirst(const Eigen::MatrixXd& factor, const double* array, long size, double* result) {
    const long terms = factor.rows(), count = factor.cols(), rest = size / terms;
    double turned[largest_array];
    Eigen::Map<Eigen::MatrixXd>(turned, rest, terms) =
        Eigen::Map<const Eigen::MatrixXd>(array, terms, rest).transpose();
    const auto contract = terms == 3 ? contractLast3 : terms == 5 ? contractLast5 : contractLast7;
    contract(factor.data(), count, turned, rest, result);
    return rest * count;
}

/// sum over (a, b, c) of x(a, i) y(b, j) z(c, k) moments[a, b, c], i fastest.
Eigen::VectorXd contract(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y, const Eigen::MatrixXd& z,
                         const Eigen::VectorXd& moments) {
    double along_x[largest_array], along_xy[largest_array];
    const long line = contractFirst(x, moments.data(), moments.size(), along_x);
    const long flat = contractFirst(y, along_x, line, along_xy);
    Eigen::VectorXd result(flat / z.rows() * z.cols());
    contractFirst(z, along_xy, flat, result.data());
    return result;
}

}  // namespace

PartIntegrals::PartIntegrals(int degree, const Vec3& edges)
    : width_(degree + 1), powers_(2 * degree + 1), edges_(edges) {
    Eigen::VectorXd line(powers_);
    for (int k = 0; k < powers_; ++k) line[k] = (std::pow(0.5, k + 1) - std::pow(-0.5, k + 1)) / (k + 1);
    whole_moments_.resize(powers_ * powers_ * powers_);
    for (int i = 0; i < whole_moments_.size(); ++i)
        whole_moments_[i] = line[i % powers_] * line[i / powers_ % powers_] * line[i / powers_ / powers_];

    const Eigen::MatrixXd value = splinePowers(degree);
    Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(width_, width_);
    for (int k = 1; k < width_; ++k) slope.row(k - 1) = k * value.row(k);
    for (int kind = 0; kind < 4; ++kind) {
        const Eigen::MatrixXd &of_a = kind & 1 ? slope : value, &of_b = kind & 2 ? slope : value;
        const bool is_symmetric = kind == 0 || kind == 3;
        Pairs& pairs = pairs_[kind];
        pairs.powers.resize(powers_, is_symmetric ? width_ * (width_ + 1) / 2 : width_ * width_);
        pairs.numbers.resize(static_cast<std::size_t>(width_ * width_));
        int count = 0;
        for (int b = 0; b < width_; ++b)
            for (int a = 0; a < width_; ++a) {
                int& number = pairs.numbers[b * width_ + a];
                if (is_symmetric && a < b) {
                    number = pairs.numbers[a * width_ + b];
                    continue;
                }
                number = count++;
                pairs.powers.col(number) = product(of_a.col(a), of_b.col(b), powers_);
            }
    }
    squares_.resize(powers_, width_);
    for (int a = 0; a < width_; ++a)
        squares_.col(a) = pairs_[0].powers.col(pairs_[0].numbers[a * width_ + a]);
    for (int shift = 0; shift < std::max(2, degree); ++shift) {
        functions_.emplace_back(Eigen::MatrixXd::Zero(powers_, width_));
        functions_.back().middleRows(shift, width_) = value;
        slopes_.emplace_back(Eigen::MatrixXd::Zero(powers_, width_));
        slopes_.back().middleRows(shift, width_) = slope;
    }
    whole_ = contracted(whole_moments_);
}

PartIntegrals::Gram PartIntegrals::gradientProducts(const CellPart& part) const {
    return part.moments.empty() ? whole_ : contracted(momentsOf(part));
}

Eigen::VectorXd PartIntegrals::squares(const CellPart& part) const {
    return contract(squares_, squares_, squares_, momentsOf(part));
}

Eigen::VectorXd PartIntegrals::momentsOf(const CellPart& part) const {
    if (part.moments.empty()) return whole_moments_;
    return Eigen::Map<const Eigen::VectorXd>(part.moments.data(), static_cast<long>(part.moments.size()));
}

/// From pairs in each direction to pairs of functions.
Eigen::MatrixXd PartIntegrals::betweenFunctions(const double* pairs, const std::array<const Pairs*, 3>& of,
                                                double scale) const {
    const int functions = width_ * width_ * width_, square = width_ * width_;
    Eigen::MatrixXd matrix(functions, functions);
    const long y_stride = of[0]->powers.cols(), z_stride = y_stride * of[1]->powers.cols();
    for (int b = 0; b < functions; ++b) {
        const int* x = of[0]->numbers.data() + b % width_ * width_;
        const int* y = of[1]->numbers.data() + b / width_ % width_ * width_;
        const int* z = of[2]->numbers.data() + b / square * width_;
        double* entry = matrix.data() + static_cast<long>(b) * functions;
        for (int az = 0; az < width_; ++az)
            for (int ay = 0; ay < width_; ++ay) {
                const double* source = pairs + z[az] * z_stride + y[ay] * y_stride;
                for (int ax = 0; ax < width_; ++ax) *entry++ = scale * source[x[ax]];
            }
    }
    return matrix;
}

PartIntegrals::Gram PartIntegrals::contracted(const Eigen::VectorXd& moments) const {
    Gram gram;
    double along_x[largest_array], along_xy[largest_array], along_xyz[most_pairs * most_pairs * most_pairs];
    // What the x-direction has is the same for up to three pairs (i, j): they follow each other.
    constexpr std::array<std::array<int, 2>, 6> directions = {
        {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
    const Pairs* last = nullptr;
    long size = 0;
    for (const auto& [i, j] : directions) {
        std::array<const Pairs*, 3> of;
        for (int d = 0; d < 3; ++d) of[d] = &pairs_[(d == i ? 1 : 0) + (d == j ? 2 : 0)];
        if (of[0] != last) size = contractFirst(of[0]->powers, moments.data(), moments.size(), along_x);
        last = of[0];
        const long flat = contractFirst(of[1]->powers, along_x, size, along_xy);
        contractFirst(of[2]->powers, along_xy, flat, along_xyz);
        gram[3 * i + j] = betweenFunctions(along_xyz, of, edges_.prod() / (edges_[i] * edges_[j]));
    }
    return gram;
}

Eigen::MatrixXd PartIntegrals::products(const CellPart& part) const {
    const Eigen::MatrixXd& powers = pairs_[0].powers;
    return betweenFunctions(contract(powers, powers, powers, momentsOf(part)).data(),
                            {&pairs_[0], &pairs_[0], &pairs_[0]}, edges_.prod());
}

Eigen::MatrixXd PartIntegrals::divergences(const CellPart& part,
                                           const std::vector<Eigen::Vector3i>& monomials) const {
    const Eigen::VectorXd moments = momentsOf(part);
    const int functions = width_ * width_ * width_;
    Eigen::MatrixXd result(static_cast<long>(monomials.size()), 3L * functions);
    for (size_t m = 0; m < monomials.size(); ++m)
        for (int i = 0; i < 3; ++i) {
            const auto factor = [&](int d) -> const Eigen::MatrixXd& {
                return (d == i ? slopes_ : functions_)[monomials[m][d]];
            };
            const Eigen::VectorXd sums =
                edges_.prod() / edges_[i] * contract(factor(0), factor(1), factor(2), moments);
            for (int f = 0; f < functions; ++f) result(static_cast<long>(m), 3L * f + i) = sums[f];
        }
    return result;
}

Eigen::MatrixXd PartIntegrals::monomialProducts(const CellPart& part,
                                                const std::vector<Eigen::Vector3i>& monomials) const {
    const Eigen::VectorXd moments = momentsOf(part);
    const auto count = static_cast<long>(monomials.size());
    Eigen::MatrixXd result(count, count);
    for (long b = 0; b < count; ++b)
        for (long a = 0; a < count; ++a) {
            const Eigen::Vector3i sum = monomials[a] + monomials[b];
            result(a, b) = edges_.prod() * moments[(sum.z() * powers_ + sum.y()) * powers_ + sum.x()];
        }
    return result;
}

Eigen::Matrix4Xd PartIntegrals::bodyMoments(const CellPart& part, const Vec3& middle) const {
    const Eigen::VectorXd moments = momentsOf(part);
    Eigen::Matrix4Xd result(4, width_ * width_ * width_);
    result.row(0) =
        edges_.prod() * contract(functions_[0], functions_[0], functions_[0], moments).transpose();
    for (int d = 0; d < 3; ++d)
        result.row(1 + d) =
            edges_.prod() * edges_[d] *
                contract(functions_[d == 0], functions_[d == 1], functions_[d == 2], moments).transpose() +
            middle[d] * result.row(0);
    return result;
}

}  // namespace sherd
