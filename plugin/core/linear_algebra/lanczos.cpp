#include "core/linear_algebra/lanczos.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sherd {

FunctionProduct functionProduct(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                const std::function<double(double)>& f) {
    constexpr double left_out = 1e-7, broken_down = 1e-13;
    constexpr long first_look = 8;
    const long size = b.size();
    const double length = b.norm();
    FunctionProduct found;
    if (!(length > 0)) {
        found.product = Eigen::VectorXd::Zero(size);
        return found;
    }
    Eigen::MatrixXd basis(size, size);
    Eigen::VectorXd diagonal(size), beside(size), next = b / length;
    double largest = 0;
    long look = first_look;
    for (long count = 1;; ++count) {
        const long last = count - 1;
        basis.col(last) = next;
        next = a.selfadjointView<Eigen::Lower>() * basis.col(last);
        diagonal[last] = basis.col(last).dot(next);
        const auto all = basis.leftCols(count);
        for (int twice = 0; twice < 2; ++twice) next -= all * (all.transpose() * next).eval();
        beside[last] = next.norm();
        largest = std::max({largest, std::abs(diagonal[last]), beside[last]});
        const bool is_complete = count == size || !(beside[last] > broken_down * largest);
        if (!is_complete && count < look) {
            next /= beside[last];
            continue;
        }
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(diagonal.head(count), beside.head(last));
        const Eigen::ArrayXd parts = solver.eigenvectors().row(0).transpose().array();
        const Eigen::VectorXd in_basis =
            solver.eigenvectors() * (solver.eigenvalues().array().unaryExpr(f) * parts).matrix();
        const double ends = last > 0 ? in_basis.tail<2>().norm() : 0;
        if (is_complete || ends < left_out * in_basis.norm()) {
            found.product = length * (all * in_basis);
            found.values = solver.eigenvalues().array();
            found.weights = parts.square();
            return found;
        }
        look = count + count / 2;
        next /= beside[last];
    }
}

}  // namespace sherd
