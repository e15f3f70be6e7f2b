#include "core/linear_algebra/cholesky_solver.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/dense.h"

namespace sherd {
namespace {

TEST(CholeskySolver, CholeskyMatchesDense) {
    const Eigen::MatrixXd root = randomMatrix(12);
    const Eigen::MatrixXd dense = root * root.transpose() + Eigen::MatrixXd::Identity(12, 12);
    const auto solver = factorCholesky(compressed(dense, Layout::lower_columns), 3);
    ASSERT_TRUE(solver.ok()) << solver.error();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(12, -1, 2);
    Eigen::VectorXd x;
    ASSERT_TRUE(solver.value()->solve(b, x));
    EXPECT_LT((dense * x - b).norm(), 1e-12);
    EXPECT_EQ(solver.value()->relativeShift(), 0);
    EXPECT_GE(solver.value()->factorEntries(), 78);
}

// Rank 9 of 12: a shift makes it possible to go on, and is reported.
TEST(CholeskySolver, SingularCholeskyIsShiftedAndSaysSo) {
    const Eigen::MatrixXd root = randomMatrix(12).leftCols(9);
    const auto solver = factorCholesky(compressed(root * root.transpose(), Layout::lower_columns), 3);
    ASSERT_TRUE(solver.ok()) << solver.error();
    EXPECT_GT(solver.value()->relativeShift(), 0);
}

}  // namespace
}  // namespace sherd
