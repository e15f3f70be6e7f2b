#pragma once

#include <sherd/types.h>

#include <Eigen/Dense>
#include <vector>

namespace sherd {

/// The binomial coefficient n over k.
double choose(int n, int k);

/// Exponents of the monomials x^i y^j z^k with i, j, k <= degree, i fastest.
std::vector<Eigen::Vector3i> monomialsOf(int degree);

/// Those of x + offset in terms of those of x: a row for each of the former.
Eigen::MatrixXd monomialsShifted(const std::vector<Eigen::Vector3i>& monomials, const Vec3& offset);

/// The value at x of a polynomial with these factors of the monomials of a degree.
template <class Factors, class Point>
auto polynomialAt(int degree, const Factors& factors, const Point& x) -> typename Factors::Scalar {
    using Scalar = typename Factors::Scalar;
    Eigen::Index m = factors.size();
    Scalar in_z = 0;
    for (int k = 0; k <= degree; ++k) {
        Scalar in_y = 0;
        for (int j = 0; j <= degree; ++j) {
            Scalar in_x = 0;
            for (int i = 0; i <= degree; ++i) in_x = in_x * x[0] + factors[--m];
            in_y = in_y * x[1] + in_x;
        }
        in_z = in_z * x[2] + in_y;
    }
    return in_z;
}

}  // namespace sherd
