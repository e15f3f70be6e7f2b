#include "core/mlpg/particle_forms/lu_solver.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/dense.h"

namespace sherd {
namespace {

TEST(LuSolver, LuMatchesDense) {
    const Eigen::MatrixXd dense = randomMatrix(12);
    const auto matrix = std::make_shared<const SparseMatrix>(compressedRows(dense));
    const auto solver = factorLu(matrix);
    ASSERT_TRUE(solver.ok()) << solver.error();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(12, -1, 2);
    Eigen::VectorXd x;
    ASSERT_TRUE(solver.value()->solve(b, x));
    EXPECT_LT((dense * x - b).norm(), 1e-11);
    EXPECT_LT((product(*matrix, x) - b).norm(), 1e-11);
}

TEST(LuSolver, SingularLuGetsASentence) {
    Eigen::MatrixXd dense = randomMatrix(6);
    dense.row(2).setZero();
    const auto solver = factorLu(std::make_shared<const SparseMatrix>(compressedRows(dense)));
    ASSERT_FALSE(solver.ok());
    EXPECT_NE(solver.error().find("singular"), std::string::npos);
}

}  // namespace
}  // namespace sherd
