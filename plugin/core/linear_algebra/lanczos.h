#pragma once

#include <Eigen/Core>
#include <functional>

namespace sherd {

/// What a function of a symmetric matrix makes of a vector.
struct FunctionProduct {
    Eigen::VectorXd product;
    /// Of the matrix, as the vector sees it: with these values and weights, which add up to 1, a function's
    /// quadratic form is the sum of weight f(value), times the vector's square.
    Eigen::ArrayXd values, weights;
};

/// f(A) b for a symmetric matrix of which the lower triangle is read: the Lanczos process with full
/// orthogonalisation (Y. Saad, SIAM J. Numer. Anal. 29 (1992) 209), until a quarter more steps change the
/// product by less than 1e-5, or A is known as far as b reaches. The values are those of Gauss' quadrature
/// (G. Golub, G. Meurant, Matrices, Moments and Quadrature, 2010).
FunctionProduct functionProduct(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                const std::function<double(double)>& f);

}  // namespace sherd
