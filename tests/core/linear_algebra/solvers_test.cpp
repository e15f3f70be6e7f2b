#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <stdexcept>

#include "core/linear_algebra/sparse_solver.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

SparseMatrix compressed(const Eigen::MatrixXd& dense, bool lower_columns) {
    SparseMatrix matrix;
    matrix.size = static_cast<int>(dense.rows());
    matrix.starts.push_back(0);
    for (int line = 0; line < matrix.size; ++line) {
        for (int k = lower_columns ? line / 3 * 3 : 0; k < matrix.size; ++k) {
            const double value = lower_columns ? dense(k, line) : dense(line, k);
            if (!lower_columns && value == 0) continue;
            matrix.indices.push_back(k);
            matrix.values.push_back(value);
        }
        matrix.starts.push_back(static_cast<int>(matrix.indices.size()));
    }
    return matrix;
}

Eigen::MatrixXd randomMatrix(int size) {
    std::mt19937 random(5);
    Eigen::MatrixXd matrix(size, size);
    for (int i = 0; i < matrix.size(); ++i) matrix(i) = random() / 4294967296.0 - 0.5;
    return matrix;
}

TEST(SparseSolver, CholeskyMatchesDense) {
    const Eigen::MatrixXd root = randomMatrix(12);
    const Eigen::MatrixXd dense = root * root.transpose() + Eigen::MatrixXd::Identity(12, 12);
    const auto solver = factorCholesky(compressed(dense, true), 3);
    ASSERT_TRUE(solver.ok()) << solver.error();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(12, -1, 2);
    Eigen::VectorXd x;
    ASSERT_TRUE(solver.value()->solve(b, x));
    EXPECT_LT((dense * x - b).norm(), 1e-12);
    EXPECT_EQ(solver.value()->relativeShift(), 0);
    EXPECT_GE(solver.value()->factorEntries(), 78);
}

// Rank 9 of 12: a shift makes it possible to go on, and is reported.
TEST(SparseSolver, SingularCholeskyIsShiftedAndSaysSo) {
    const Eigen::MatrixXd root = randomMatrix(12).leftCols(9);
    const auto solver = factorCholesky(compressed(root * root.transpose(), true), 3);
    ASSERT_TRUE(solver.ok()) << solver.error();
    EXPECT_GT(solver.value()->relativeShift(), 0);
}

TEST(SparseSolver, LuMatchesDense) {
    const Eigen::MatrixXd dense = randomMatrix(12);
    const auto matrix = std::make_shared<const SparseMatrix>(compressed(dense, false));
    const auto solver = factorLu(matrix);
    ASSERT_TRUE(solver.ok()) << solver.error();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(12, -1, 2);
    Eigen::VectorXd x;
    ASSERT_TRUE(solver.value()->solve(b, x));
    EXPECT_LT((dense * x - b).norm(), 1e-11);
    EXPECT_LT((product(*matrix, x) - b).norm(), 1e-11);
}

TEST(SparseSolver, SingularLuGetsASentence) {
    Eigen::MatrixXd dense = randomMatrix(6);
    dense.row(2).setZero();
    const auto solver = factorLu(std::make_shared<const SparseMatrix>(compressed(dense, false)));
    ASSERT_FALSE(solver.ok());
    EXPECT_NE(solver.error().find("singular"), std::string::npos);
}

TEST(ParallelChunks, EveryChunkOnceAndExceptionsCome) {
    std::vector<std::atomic<int>> runs(100);
    forEachChunk(100, [&](int chunk) { ++runs[chunk]; });
    for (const auto& count : runs) EXPECT_EQ(count, 1);
    EXPECT_THROW(forEachChunk(8,
                              [](int chunk) {
                                  if (chunk == 5) throw std::runtime_error("chunk");
                              }),
                 std::runtime_error);
    EXPECT_EQ(chunkBegin(0, 7, 100), 0);
    EXPECT_EQ(chunkBegin(7, 7, 100), 100);
}

}  // namespace
}  // namespace sherd
