#pragma once

#include <vector>

namespace sherd {

/// Gauss-Legendre quadrature on [-1/2, 1/2]; the weights add up to 1. Exact to degree 2 #points - 1.
struct GaussRule {
    std::vector<double> points;  ///< ascending
    std::vector<double> weights;
};

GaussRule gaussLegendre(int count);

}  // namespace sherd
