#include "core/mlpg/splines/spline_refinement.h"

#include <algorithm>
#include <cmath>

#include "core/mlpg/splines/b_spline.h"

namespace sherd {
namespace {

/// Elementary symmetric polynomial e_k(t, t + s, ..., t + (n - 1) s) over binomial(n, k): the polar form
/// (blossom) of x^k as a polynomial of degree n.
double polarPower(int k, int n, double t, double s) {
    std::vector<double> e(n + 1, 0.0);
    e[0] = 1;
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j > 0; --j) e[j] += e[j - 1] * (t + i * s);
    double binomial = 1;
    for (int i = 0; i < k; ++i) binomial = binomial * (n - i) / (i + 1);
    return e[k] / binomial;
}

/// One direction: from a coarse cell's coefficients to those of a fine cell half as long whose middle lies at
/// `middle` (coarse edges from the middle of the coarse cell). The coefficient of a B-spline of degree p is
/// the polar form of the polynomial at its p inner knots.
Eigen::MatrixXd childMatrix(int degree, const Eigen::MatrixXd& powers, double middle) {
    Eigen::MatrixXd polar(degree + 1, degree + 1);
    for (int a = 0; a <= degree; ++a) {
        const double first_knot = middle - 0.25 + 0.5 * (a - degree + 1);
        for (int k = 0; k <= degree; ++k) polar(a, k) = polarPower(k, degree, first_knot, 0.5);
    }
    return polar * powers;
}

}  // namespace

std::vector<int> parentParts(const CellParts& coarse, const CellParts& fine) {
    std::vector<int> parents;
    const int n = fine.order + 1;
    for (const CellPart& part : fine.parts) {
        Vec3 xi = Vec3::Constant(0.5) + part.cell.cast<double>();
        if (!part.moments.empty()) {
            const Vec3 first(part.moments[1], part.moments[n], part.moments[n * n]);
            xi += (first / part.fill).cwiseMax(-0.499).cwiseMin(0.499);
        }
        parents.push_back(coarse.partAt(fine.origin + xi.cwiseProduct(fine.edges)));
    }
    return parents;
}

Eigen::Matrix3Xd refinedCoefficients(const CellParts& coarse, const SplineSpace& coarse_space,
                                     const Eigen::Matrix3Xd& coarse_raw, const CellParts& fine,
                                     const SplineSpace& fine_space, const std::vector<int>& parents) {
    const int degree = fine_space.degree, width = degree + 1, per_part = fine_space.perPart();
    const Eigen::MatrixXd powers = splinePowers(degree);
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, fine_space.raw_count);
    std::vector<char> done(fine_space.raw_count, 0);
    Eigen::Matrix3Xd own(3, per_part), turned(3, per_part);
    for (size_t p = 0; p < fine.parts.size(); ++p) {
        if (parents[p] < 0) continue;
        const std::vector<int>& functions = fine_space.raw_of[p];
        if (std::all_of(functions.begin(), functions.end(), [&](int f) { return done[f]; })) continue;
        const CellPart& parent = coarse.parts[parents[p]];
        const Vec3 middle =
            fine.origin + (fine.parts[p].cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(fine.edges);
        // Middles lie a quarter of an edge from the coarse one's; rounding must not enter.
        const Vec3 xi = (coarse.toCell(middle, parent.cell) * 4).array().round() / 4;
        for (int a = 0; a < per_part; ++a) own.col(a) = coarse_raw.col(coarse_space.raw_of[parents[p]][a]);
        // Each pass turns one index and moves it to the end, so that three passes restore the order.
        for (int d = 0; d < 3; ++d) {
            const Eigen::MatrixXd child = childMatrix(degree, powers, xi[d]);
            turned.setZero();
            for (int rest = 0; rest < width * width; ++rest)
                for (int to = 0; to < width; ++to)
                    for (int from = 0; from < width; ++from)
                        turned.col(to * width * width + rest) +=
                            child(to, from) * own.col(rest * width + from);
            own.swap(turned);
        }
        for (int a = 0; a < per_part; ++a) {
            if (done[functions[a]]) continue;
            done[functions[a]] = 1;
            raw.col(functions[a]) = own.col(a);
        }
    }
    return raw;
}

}  // namespace sherd
