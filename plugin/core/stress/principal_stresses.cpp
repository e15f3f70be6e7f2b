#include "core/stress/principal_stresses.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/stress/elasticity.h"

namespace sherd {

namespace {

/// Ascending.
Vec3 eigenvalues(const SymmetricTensor& stress) {
    // Scaled first: the closed form cubes its entries, which would overflow or vanish for extreme units.
    const double scale = stress.cwiseAbs().maxCoeff();
    if (!(scale > 0) || !std::isfinite(scale)) return {-scale, scale, scale};
    const Mat3 scaled = toMatrix(stress / scale);
    const Mat3 deviator = scaled - scaled.trace() / 3 * Mat3::Identity();
    const bool turned =
        deviator.determinant() < 0;  // so that mirrored stress has mirrored values, to the bit
    Eigen::SelfAdjointEigenSolver<Mat3> spectrum;
    spectrum.computeDirect(turned ? -scaled : scaled, Eigen::EigenvaluesOnly);
    const Vec3 values = scale * spectrum.eigenvalues();
    return turned ? Vec3(-values.reverse()) : values;
}

}  // namespace

double largestPrincipal(const SymmetricTensor& stress) {
    return eigenvalues(stress)[2];
}

PrincipalStresses principalStresses(const SymmetricTensor& stress) {
    const Vec3 values = eigenvalues(stress);
    return {values[2], values[1], values[0]};
}

}  // namespace sherd
