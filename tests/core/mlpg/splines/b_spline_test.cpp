#include "core/mlpg/splines/b_spline.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

// Paper, Eq. 6-10, with tensor products of B-splines as weights and particles on a whole lattice: phi_i = p^T
// M^-1 p_i w_i must be the B-splines themselves.
TEST(Spline, AreMovingLeastSquaresWithSplineWeights) {
    for (int degree = 1; degree <= 3; ++degree) {
        const Vec3 xi(0.21, -0.37, 0.05);
        std::vector<double> weights;
        splineValues(degree, xi, weights);
        const int width = degree + 1;
        Eigen::Matrix4d moment = Eigen::Matrix4d::Zero();
        std::vector<Eigen::Vector4d> basis;
        for (size_t n = 0; n < weights.size(); ++n) {
            const Vec3 node =
                Vec3(n % width, n / width % width, n / width / width) - Vec3::Constant(degree / 2.0);
            basis.emplace_back(1, node.x() - xi.x(), node.y() - xi.y(), node.z() - xi.z());
            moment += weights[n] * basis[n] * basis[n].transpose();
        }
        const Eigen::Vector4d p = moment.inverse().col(0);
        for (size_t n = 0; n < weights.size(); ++n)
            EXPECT_NEAR(p.dot(basis[n]) * weights[n], weights[n], 1e-14);
    }
}

TEST(Spline, GradientsAreThoseOfTheValues) {
    constexpr double step = 1e-6;
    for (int degree = 1; degree <= 3; ++degree) {
        const Vec3 xi(0.11, 0.29, -0.44);
        std::vector<Vec3> gradients;
        splineGradients(degree, xi, gradients);
        for (int d = 0; d < 3; ++d) {
            std::vector<double> above, below;
            splineValues(degree, xi + step * Vec3::Unit(d), above);
            splineValues(degree, xi - step * Vec3::Unit(d), below);
            for (size_t a = 0; a < gradients.size(); ++a)
                EXPECT_NEAR(gradients[a][d], (above[a] - below[a]) / (2 * step), 1e-8);
        }
    }
}

}  // namespace
}  // namespace sherd
