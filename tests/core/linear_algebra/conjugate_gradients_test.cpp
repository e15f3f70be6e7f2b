#include "core/linear_algebra/conjugate_gradients.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/dense.h"

namespace sherd {
namespace {

// Tridiagonal (-1, 2, -1) and a known solution.
TEST(ConjugateGradients, SolveAndSayWhenTheyCannot) {
    constexpr int size = 60;
    SparseMatrix lower;
    lower.size = size;
    lower.starts.push_back(0);
    for (int i = 0; i < size; ++i) {
        lower.indices.push_back(i);
        lower.values.push_back(2);
        if (i + 1 < size) {
            lower.indices.push_back(i + 1);
            lower.values.push_back(-1);
        }
        lower.starts.push_back(static_cast<int>(lower.indices.size()));
    }
    const Eigen::VectorXd expected = randomVector(size, 5);
    Eigen::VectorXd b = 2 * expected;
    b.head(size - 1) -= expected.tail(size - 1);
    b.tail(size - 1) -= expected.head(size - 1);
    const Result<Eigen::VectorXd> x = solveByConjugateGradients(lower, b, 1e-12);
    ASSERT_TRUE(x.ok()) << x.error();
    EXPECT_LT((x.value() - expected).norm(), 1e-9);
    EXPECT_FALSE(solveByConjugateGradients(lower, b, 0).ok());
}

}  // namespace
}  // namespace sherd
