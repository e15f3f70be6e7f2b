#include "core/mlpg/splines/monomials.h"

namespace sherd {
namespace {

double power(double x, int exponent) {
    double value = 1;
    for (int i = 0; i < exponent; ++i) value *= x;
    return value;
}

}  // namespace

double choose(int n, int k) {
    double value = 1;
    for (int i = 0; i < k; ++i) value *= static_cast<double>(n - i) / (i + 1);
    return value;
}

std::vector<Eigen::Vector3i> monomialsOf(int degree) {
    std::vector<Eigen::Vector3i> monomials;
    for (int k = 0; k <= degree; ++k)
        for (int j = 0; j <= degree; ++j)
            for (int i = 0; i <= degree; ++i) monomials.emplace_back(i, j, k);
    return monomials;
}

Eigen::MatrixXd monomialsShifted(const std::vector<Eigen::Vector3i>& monomials, const Vec3& offset) {
    const long count = static_cast<long>(monomials.size());
    Eigen::MatrixXd shifted = Eigen::MatrixXd::Zero(count, count);
    for (long row = 0; row < count; ++row)
        for (long column = 0; column < count; ++column) {
            const Eigen::Vector3i of = monomials[row], left = of - monomials[column];
            if (left.minCoeff() < 0) continue;
            double factor = 1;
            for (int d = 0; d < 3; ++d) factor *= choose(of[d], left[d]) * power(offset[d], left[d]);
            shifted(row, column) = factor;
        }
    return shifted;
}

}  // namespace sherd
