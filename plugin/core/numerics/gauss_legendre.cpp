#include "core/numerics/gauss_legendre.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace sherd {

/// Golub and Welsch (1969): points are eigenvalues of the Jacobi matrix, weights come from its eigenvectors.
GaussRule gaussLegendre(int count) {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(count, count);
    for (int k = 1; k < count; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(jacobi);
    GaussRule rule;
    for (int k = 0; k < count; ++k) {
        const double component = spectrum.eigenvectors()(0, k);
        rule.points.push_back(spectrum.eigenvalues()[k] / 2);
        rule.weights.push_back(component * component);
    }
    return rule;
}

}  // namespace sherd
