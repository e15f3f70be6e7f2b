#include <sherd/stress_field.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/stress/elasticity.h"

namespace sherd {

double largestPrincipal(const Voigt& stress) {
    // Scaled first: the closed form cubes its entries, which would overflow or vanish for extreme units.
    const double scale = stress.cwiseAbs().maxCoeff();
    if (!(scale > 0) || !std::isfinite(scale)) return scale;
    Eigen::SelfAdjointEigenSolver<Mat3> spectrum;
    spectrum.computeDirect(toMatrix(stress / scale), Eigen::EigenvaluesOnly);
    return scale * spectrum.eigenvalues()[2];
}

}  // namespace sherd
