#include "core/linear_algebra/conjugate_gradients.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/dense.h"

namespace sherd {
namespace {

// Tridiagonal (-1, 2, -1) and a known solution.
TEST(ConjugateGradients, SolveAndSayWhenTheyCannot) {
    constexpr int size = 60;
    Eigen::MatrixXd dense = 2 * Eigen::MatrixXd::Identity(size, size);
    dense.diagonal(1).setConstant(-1);
    dense.diagonal(-1).setConstant(-1);
    const BlockMatrix matrix = inBlocks(dense);
    const Eigen::VectorXd expected = randomVector(size, 5);
    const Eigen::VectorXd b = dense * expected;
    const Result<Eigen::VectorXd> x = solveByConjugateGradients(matrix, b, 1e-12);
    ASSERT_TRUE(x.ok()) << x.error();
    EXPECT_LT((x.value() - expected).norm(), 1e-9);
    EXPECT_FALSE(solveByConjugateGradients(matrix, b, 0).ok());
}

}  // namespace
}  // namespace sherd
