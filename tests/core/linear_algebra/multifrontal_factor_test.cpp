#include "core/linear_algebra/multifrontal_factor.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/block_product.h"
#include "core/linear_algebra/dense.h"
#include "core/linear_algebra/lattice_matrix.h"
#include "core/linear_algebra/least_fill.h"

#ifdef __linux__
#include <sched.h>

#include <thread>
#endif

namespace sherd {
namespace {

class MultifrontalFactors : public testing::Test {
  protected:
    double residual(const Eigen::VectorXd& x, double shift) const {
        return (blockProduct(lattice_.matrix, x) + shift * x - b_).norm();
    }

    const LatticeMatrix lattice_{14, 9, 3};
    const BlockGraph graph_ = blockGraph(lattice_.matrix.starts, lattice_.matrix.rows);
    const EliminationTree tree_ = leastFill(graph_, lattice_.places);
    const Eigen::VectorXd b_ = randomVector(lattice_.matrix.size(), 7);
};

TEST_F(MultifrontalFactors, SolveTheSystem) {
    MultifrontalFactor<double> factor(graph_, tree_, 3);
    ASSERT_TRUE(factor.factor(graph_, lattice_.matrix, 0));
    EXPECT_LT(residual(factor.solve(b_), 0), 1e-12 * b_.norm());
    EXPECT_GE(factor.entries(), 9 * tree_.blocks());
    EXPECT_LT(factor.entries(), 1.6 * 9 * tree_.blocks());
    EXPECT_GT(factor.reciprocalCondition(), 0.3);
    EXPECT_LE(factor.reciprocalCondition(), 1);
}

// More columns than pass through the factor at once.
TEST_F(MultifrontalFactors, SolveManyColumnsAsOneByOne) {
    MultifrontalFactor<double> factor(graph_, tree_, 3);
    ASSERT_TRUE(factor.factor(graph_, lattice_.matrix, 0));
    Eigen::MatrixXd b(lattice_.matrix.size(), 301);
    for (int j = 0; j < b.cols(); ++j) b.col(j) = randomVector(b.rows(), 20 + j);
    const Eigen::MatrixXd x = factor.solve(b);
    ASSERT_EQ(x.cols(), b.cols());
    for (int j = 0; j < b.cols(); ++j)
        ASSERT_LT((x.col(j) - factor.solve(b.col(j))).norm(), 1e-13 * x.col(j).norm()) << j;
}

TEST_F(MultifrontalFactors, AddAShiftToTheDiagonal) {
    MultifrontalFactor<double> factor(graph_, tree_, 3);
    ASSERT_TRUE(factor.factor(graph_, lattice_.matrix, 5));
    EXPECT_LT(residual(factor.solve(b_), 5), 1e-12 * b_.norm());
}

TEST_F(MultifrontalFactors, RefuseWhatIsNotPositiveDefinite) {
    MultifrontalFactor<double> factor(graph_, tree_, 3);
    EXPECT_FALSE(factor.factor(graph_, lattice_.matrix, -1000));
    ASSERT_TRUE(factor.factor(graph_, lattice_.matrix, 0)) << "and can be used again";
    EXPECT_LT(residual(factor.solve(b_), 0), 1e-12 * b_.norm());
}

#ifdef __linux__
TEST_F(MultifrontalFactors, HaveTheSameBitsOnOneCore) {
    MultifrontalFactor<double> on_all(graph_, tree_, 3), on_one(graph_, tree_, 3);
    ASSERT_TRUE(on_all.factor(graph_, lattice_.matrix, 0));
    bool done = false;
    std::thread([&] {
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(sched_getcpu(), &one);
        sched_setaffinity(0, sizeof one, &one);
        done = on_one.factor(graph_, lattice_.matrix, 0);
    }).join();
    ASSERT_TRUE(done);
    EXPECT_EQ(on_all.solve(b_), on_one.solve(b_));
}
#endif

}  // namespace
}  // namespace sherd
