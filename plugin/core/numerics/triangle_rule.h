#pragma once

#include <vector>

namespace sherd {

/// Quadrature on the triangle (0, 0), (1, 0), (0, 1); the weights add up to its area, 1/2.
struct TriangleRule {
    std::vector<double> u, v, weights;
};

/// Exact for polynomials up to an even `degree`: the symmetric rules of Dunavant (1985) for 4, 8 and 12, for
/// others a collapsed Gauss rule, which has half as many points more.
TriangleRule triangleRule(int degree);

}  // namespace sherd
