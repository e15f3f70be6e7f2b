#include "core/mlpg/splines/part_integrals.h"

#include <cmath>

#include "core/mlpg/splines/b_spline.h"

namespace sherd {
namespace {

/// Product of polynomials given by their powers.
Eigen::RowVectorXd product(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int powers) {
    Eigen::RowVectorXd c = Eigen::RowVectorXd::Zero(powers);
    for (long i = 0; i < a.size(); ++i)
        for (long j = 0; j < b.size() && i + j < powers; ++j) c[i + j] += a[i] * b[j];
    return c;
}

/// Contracts the first index of an array with the second of `factor`, and moves it to the end.
Eigen::VectorXd contractFirst(const Eigen::MatrixXd& factor, const Eigen::VectorXd& array) {
    const long rest = array.size() / factor.cols();
    const Eigen::Map<const Eigen::MatrixXd> in(array.data(), factor.cols(), rest);
    Eigen::VectorXd result(rest * factor.rows());
    Eigen::Map<Eigen::MatrixXd>(result.data(), rest, factor.rows()).noalias() =
        in.transpose().lazyProduct(factor.transpose());
    return result;
}

/// sum over (a, b, c) of x(i, a) y(j, b) z(k, c) moments[a, b, c], i fastest.
Eigen::VectorXd contract(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y, const Eigen::MatrixXd& z,
                         const Eigen::VectorXd& moments) {
    return contractFirst(z, contractFirst(y, contractFirst(x, moments)));
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
        pairs_[kind].resize(width_ * width_, powers_);
        for (int b = 0; b < width_; ++b)
            for (int a = 0; a < width_; ++a)
                pairs_[kind].row(b * width_ + a) =
                    product((kind & 1 ? slope : value).col(a), (kind & 2 ? slope : value).col(b), powers_);
    }
    squares_.resize(width_, powers_);
    for (int a = 0; a < width_; ++a) squares_.row(a) = pairs_[0].row(a * width_ + a);
    for (int shift = 0; shift < 2; ++shift) {
        functions_[shift] = Eigen::MatrixXd::Zero(width_, powers_);
        functions_[shift].middleCols(shift, width_) = value.transpose();
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

PartIntegrals::Gram PartIntegrals::contracted(const Eigen::VectorXd& moments) const {
    const int functions = width_ * width_ * width_, pairs = width_ * width_;
    Gram gram;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i <= j; ++i) {
            const auto factor = [&](int d) -> const Eigen::MatrixXd& {
                return pairs_[(d == i ? 1 : 0) + (d == j ? 2 : 0)];
            };
            const Eigen::VectorXd all = contract(factor(0), factor(1), factor(2), moments);
            const double scale = edges_.prod() / (edges_[i] * edges_[j]);
            Eigen::MatrixXd& target = gram[3 * i + j];
            target.resize(functions, functions);
            // From pairs in each direction to a pair of functions.
            for (int b = 0; b < functions; ++b) {
                const int bx = b % width_ * width_, by = b / width_ % width_ * width_,
                          bz = b / pairs * width_;
                double* entry = target.data() + static_cast<long>(b) * functions;
                for (int az = 0; az < width_; ++az)
                    for (int ay = 0; ay < width_; ++ay) {
                        const double* source = all.data() + ((bz + az) * pairs + by + ay) * pairs + bx;
                        for (int ax = 0; ax < width_; ++ax) *entry++ = scale * source[ax];
                    }
            }
        }
    return gram;
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
