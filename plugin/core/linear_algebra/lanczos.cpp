#include "core/linear_algebra/lanczos.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace sherd {

FunctionProduct functionProduct(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                const std::function<double(double)>& f) {
    constexpr double left_out = 1e-5, broken_down = 1e-13;
    constexpr long first_look = 8;  // and a quarter more each time
    const long size = b.size();
    const double length = b.norm();
    FunctionProduct found;
    if (!(length > 0)) {
        found.product = Eigen::VectorXd::Zero(size);
        return found;
    }
    Eigen::MatrixXd basis(size, size);
    Eigen::VectorXd diagonal(size), beside(size), next = b / length;
    Eigen::VectorXd before;  // what was found at the last look
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
        // Small last parts alone may be chance.
        const double change = before.size() == 0 ? in_basis.norm()
                                                 : std::max((in_basis.head(before.size()) - before).norm(),
                                                            in_basis.tail(count - before.size()).norm());
        if (is_complete || change < left_out * in_basis.norm()) {
            found.product = length * (all * in_basis);
            found.values = solver.eigenvalues().array();
            found.weights = parts.square();
            return found;
        }
        before = in_basis;
        look = count + count / 4 + 1;
        next /= beside[last];
    }
}

}  // namespace sherd
