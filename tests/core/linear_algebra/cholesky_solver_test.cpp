#include "core/linear_algebra/cholesky_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/linear_algebra/block_product.h"
#include "core/linear_algebra/dense.h"
#include "core/linear_algebra/lattice_matrix.h"
#include "core/mlpg/pinned_system.h"

namespace sherd {
namespace {

TEST(CholeskySolver, CholeskyMatchesDense) {
    const Eigen::MatrixXd root = randomMatrix(12);
    const Eigen::MatrixXd dense = root * root.transpose() + Eigen::MatrixXd::Identity(12, 12);
    const auto solver = factorCholesky(inBlocks(dense));
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
    const auto solver = factorCholesky(inBlocks(root * root.transpose()));
    ASSERT_TRUE(solver.ok()) << solver.error();
    EXPECT_GT(solver.value()->relativeShift(), 0);
}

double residualOf(const SparseSolver& solver, const Eigen::MatrixXd& dense) {
    const Eigen::VectorXd b = randomVector(dense.rows(), 7);
    Eigen::VectorXd x;
    EXPECT_TRUE(solver.solve(b, x));
    return (dense * x - b).norm() / b.norm();
}

/// Symmetric, with eigenvalues from 1 down to the smallest in even powers.
Eigen::MatrixXd matrixWith(double smallest_eigenvalue) {
    const Eigen::MatrixXd q = randomMatrix(12).householderQr().householderQ();
    Eigen::VectorXd values(12);
    for (int i = 0; i < 12; ++i) values[i] = std::pow(smallest_eigenvalue, i / 11.0);
    return q * values.asDiagonal() * q.transpose();
}

TEST(CholeskySolver, SinglePrecisionIsTakenWhereItCanBeRefined) {
    for (const double smallest : {1e-1, 1e-3}) {
        const Eigen::MatrixXd dense = matrixWith(smallest);
        const auto lower = inBlocks(dense);
        const auto refined = factorCholesky(lower, {}, Precision::refined);
        ASSERT_TRUE(refined.ok()) << refined.error();
        EXPECT_GT(residualOf(*refined.value(), dense), 1e-9) << smallest;
        EXPECT_LT(residualOf(*refined.value(), dense), 1e-2) << smallest;
        const auto full = factorCholesky(lower);
        EXPECT_LT(residualOf(*full.value(), dense), 1e-11) << smallest;
        EXPECT_EQ(refined.value()->factorBytes(), 4 * refined.value()->factorEntries());
        EXPECT_EQ(full.value()->factorBytes(), 8 * full.value()->factorEntries());
    }
}

TEST(CholeskySolver, WhatSinglePrecisionCannotHoldGetsDouble) {
    const Eigen::MatrixXd dense = matrixWith(1e-9);
    const auto refined = factorCholesky(inBlocks(dense), {}, Precision::refined);
    ASSERT_TRUE(refined.ok()) << refined.error();
    EXPECT_LT(residualOf(*refined.value(), dense), 1e-6);
    EXPECT_EQ(refined.value()->relativeShift(), 0);
}

TEST(CholeskySolver, SinglePrecisionFindsSingularMatricesToo) {
    const Eigen::MatrixXd root = randomMatrix(12).leftCols(9);
    const auto solver = factorCholesky(inBlocks(root * root.transpose()), {}, Precision::refined);
    ASSERT_TRUE(solver.ok()) << solver.error();
    EXPECT_GT(solver.value()->relativeShift(), 0);
}

TEST(PinnedSystem, LeavesTheMatrixAsItWas) {
    LatticeMatrix lattice(9, 8, 4);
    const std::vector<double> before = lattice.matrix.values;
    const auto factored = [&](const std::vector<int>& pinned) {
        return PinnedSystem::factor(lattice.matrix, pinned, lattice.places).ok();
    };
    EXPECT_TRUE(factored({0, 1, 2, 100, 431}));
    EXPECT_EQ(lattice.matrix.values, before);
    // Nor where it has no factor.
    *lattice.matrix.column(2, 0) = std::nan("");
    *lattice.matrix.column(0, 1) = -2;
    EXPECT_FALSE(factored({1}));
    EXPECT_EQ(*lattice.matrix.column(0, 1), -2);
}

TEST(CholeskySolver, RefinedSolutionsAreThoseOfDouble) {
    LatticeMatrix lattice(9, 8, 4);
    for (const double size : {1.0, 1e-50, 1e50}) {
        const Eigen::VectorXd b = size * randomVector(lattice.matrix.size(), 11);
        const auto residual = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return b - blockProduct(lattice.matrix, x);
        };
        const auto solved = [&](Precision precision) {
            const auto system = PinnedSystem::factor(lattice.matrix, {}, lattice.places, precision);
            EXPECT_TRUE(system.ok());
            EXPECT_EQ(system.value().solver().isSingle(), precision == Precision::refined);
            return system.value().solve(b, residual, 1e-12).value();
        };
        const PinnedSystem::Solution refined = solved(Precision::refined), full = solved(Precision::full);
        EXPECT_LT(refined.residual_rel, 1e-12) << size;
        EXPECT_LT((refined.unknowns - full.unknowns).norm(), 1e-11 * full.unknowns.norm()) << size;
    }
}

}  // namespace
}  // namespace sherd
