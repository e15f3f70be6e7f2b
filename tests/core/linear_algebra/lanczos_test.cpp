#include "core/linear_algebra/lanczos.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

namespace sherd {
namespace {

double halved(double value) {
    return 1 / (2 + value);
}

/// Symmetric, not negative, with values up to the square of some more than its size.
Eigen::MatrixXd randomMatrix(int size) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
    return root * root.transpose();
}

Eigen::VectorXd byAllEigenvectors(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(a);
    const Eigen::VectorXd parts = solver.eigenvectors().transpose() * b;
    return solver.eigenvectors() * (solver.eigenvalues().array().unaryExpr(&halved) * parts.array()).matrix();
}

TEST(Lanczos, AppliesAFunctionOfAMatrix) {
    for (const int size : {1, 2, 7, 40, 150}) {
        const Eigen::MatrixXd a = randomMatrix(size);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, 1, -2);
        const FunctionProduct found = functionProduct(a.triangularView<Eigen::Lower>(), b, halved);
        const Eigen::VectorXd exact = byAllEigenvectors(a, b);
        EXPECT_LT((found.product - exact).norm(), 1e-5 * exact.norm()) << size;
        EXPECT_NEAR(found.weights.sum(), 1, 1e-12);
        const double form = b.squaredNorm() * (found.weights * found.values.unaryExpr(&halved)).sum();
        EXPECT_NEAR(form, b.dot(exact), 1e-5 * b.dot(exact));
    }
}

TEST(Lanczos, EndsWhereTheMatrixTakesTheVectorNoFurther) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(30, 30);
    a.diagonal().setLinSpaced(0, 29);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(30);
    b[4] = 3, b[20] = 4;
    const FunctionProduct found = functionProduct(a, b, halved);
    ASSERT_EQ(found.values.size(), 2);
    EXPECT_NEAR(found.values[0], 4, 1e-12);
    EXPECT_NEAR(found.weights[1], 16.0 / 25, 1e-12);
    EXPECT_NEAR(found.product[20], 4 * halved(20), 1e-12);
    EXPECT_EQ(functionProduct(a, Eigen::VectorXd::Zero(30), halved).product.norm(), 0);
}

}  // namespace
}  // namespace sherd
