#include "core/mlpg/splines/part_integrals.h"

#include <gtest/gtest.h>

#include "core/mlpg/splines/b_spline.h"
#include "core/numerics/gauss_legendre.h"

namespace sherd {
namespace {

// Whole cells: the contraction of moments against a Gauss rule that is exact.
TEST(PartIntegrals, AgreeWithQuadrature) {
    const Vec3 edges(0.2, 0.3, 0.1);
    for (int degree = 1; degree <= 3; ++degree) {
        const PartIntegrals integrals(degree, edges);
        const GaussRule rule = gaussLegendre(degree + 1);
        const size_t count = (degree + 1) * (degree + 1) * (degree + 1);
        Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(count, count);
        std::vector<Vec3> gradients;
        for (size_t q = 0; q < count; ++q) {
            const size_t i = q % (degree + 1), j = q / (degree + 1) % (degree + 1),
                         k = q / (degree + 1) / (degree + 1);
            splineGradients(degree, Vec3(rule.points[i], rule.points[j], rule.points[k]), gradients);
            const double weight = edges.prod() * rule.weights[i] * rule.weights[j] * rule.weights[k];
            for (size_t a = 0; a < count; ++a)
                for (size_t b = 0; b < count; ++b)
                    expected(a, b) += weight * gradients[a].x() / edges.x() * gradients[b].z() / edges.z();
        }
        EXPECT_LT((integrals.wholeCell()[2] - expected).norm(), 1e-12 * expected.norm());
    }
}

}  // namespace
}  // namespace sherd
