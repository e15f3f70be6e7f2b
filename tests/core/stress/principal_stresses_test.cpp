#include "core/stress/principal_stresses.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "core/stress/elasticity.h"

namespace sherd {
namespace {

TEST(LargestPrincipal, ClosedForms) {
    EXPECT_EQ(largestPrincipal(SymmetricTensor::Zero()), 0);
    EXPECT_NEAR(largestPrincipal((SymmetricTensor() << -3, -1, -2, 0, 0, 0).finished()), -1, 1e-14);
    EXPECT_NEAR(largestPrincipal((SymmetricTensor() << 0, 0, 0, 5, 0, 0).finished()), 5,
                1e-13);  // pure shear
    EXPECT_NEAR(largestPrincipal((SymmetricTensor() << 7, 7, 7, 0, 0, 0).finished()), 7,
                1e-14);  // hydrostatic
    EXPECT_NEAR(largestPrincipal((SymmetricTensor() << 1, 2, 3, 0.4, -0.5, 0.6).finished() * 1e200) / 1e200,
                largestPrincipal((SymmetricTensor() << 1, 2, 3, 0.4, -0.5, 0.6).finished()), 1e-13);
}

// xy, yz, zx each in its place: against the full eigenvalue solver.
TEST(LargestPrincipal, MatchesTheIterativeSolver) {
    const SymmetricTensor stress = (SymmetricTensor() << 1, -2, 3, 0.7, -1.5, 2.6).finished();
    Mat3 tensor;
    tensor << 1, 0.7, 2.6, 0.7, -2, -1.5, 2.6, -1.5, 3;
    EXPECT_EQ(toMatrix(stress), tensor);
    EXPECT_EQ(toSymmetricTensor(tensor), stress);
    const Eigen::SelfAdjointEigenSolver<Mat3> spectrum(tensor);
    EXPECT_NEAR(largestPrincipal(stress), spectrum.eigenvalues()[2], 1e-12);
    const PrincipalStresses principal = principalStresses(stress), mirrored = principalStresses(-stress);
    EXPECT_EQ(principal.largest, largestPrincipal(stress));
    EXPECT_NEAR(principal.middle, spectrum.eigenvalues()[1], 1e-12);
    EXPECT_NEAR(principal.smallest, spectrum.eigenvalues()[0], 1e-12);
    EXPECT_EQ(mirrored.smallest, -principal.largest);
    EXPECT_EQ(mirrored.middle, -principal.middle);
    EXPECT_EQ(mirrored.largest, -principal.smallest);
}

// sigma = E eps in uniaxial tension, where the lateral strain is -nu eps; a rotation makes no stress.
TEST(Elasticity, UniaxialTension) {
    Material material;
    material.youngs_modulus_pa = 10;
    material.poisson_ratio = 0.3;
    const Elasticity law(material);
    const Mat3 stress = law.stress(Vec3(1, -0.3, -0.3).asDiagonal());
    EXPECT_LT((stress - Mat3(Vec3(10, 0, 0).asDiagonal())).norm(), 1e-13);
    Mat3 rotation;
    rotation << 0, 1, -2, -1, 0, 3, 2, -3, 0;
    EXPECT_EQ(law.stress(rotation).norm(), 0);
}

}  // namespace
}  // namespace sherd
