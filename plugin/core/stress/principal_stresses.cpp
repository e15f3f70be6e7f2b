#include "core/stress/principal_stresses.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/stress/elasticity.h"

namespace sherd {

double largestPrincipal(const SymmetricTensor& stress) {
    // Scaled first: the closed form cubes its entries, which would overflow or vanish for extreme units.
    const double scale = stress.cwiseAbs().maxCoeff();
    if (!(scale > 0) || !std::isfinite(scale)) return scale;
    Eigen::SelfAdjointEigenSolver<Mat3> spectrum;
    spectrum.computeDirect(toMatrix(stress / scale), Eigen::EigenvaluesOnly);
    return scale * spectrum.eigenvalues()[2];
}

PrincipalStresses principalStresses(const SymmetricTensor& stress) {
    PrincipalStresses principal;
    principal.largest = largestPrincipal(stress);
    principal.smallest = -largestPrincipal(-stress);
    const double rest = stress[0] + stress[1] + stress[2] - (principal.largest + principal.smallest);
    principal.middle = std::min(std::max(rest, principal.smallest), principal.largest);
    return principal;
}

}  // namespace sherd
