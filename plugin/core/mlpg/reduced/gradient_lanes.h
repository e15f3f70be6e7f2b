#pragma once

#include <sherd/settings.h>

#include <Eigen/Dense>

namespace sherd {

/// Points of a part side by side, each in a lane of its own: what is done to one is done to all.
struct GradientLanes {
    static constexpr int count = 16;
    using Lane = float[count];
    Lane xi[3];           ///< in the cell of the part, edges from the middle
    Lane gradient[3][3];  ///< of the displacement: component, direction
};

/// A displacement on one part.
struct PartCoefficients {
    static constexpr int most = largest_spline_degree + 1;
    float of_function[most * most * most][4];  ///< a vector and a zero for each, x fastest
};

/// Displacement gradients at `points.xi`, summed one direction after the other. `powers`: of the pieces of
/// the splines; `per_edge`: 1 / the edges of a cell, 1 / m.
void findGradients(int degree, const Eigen::MatrixXf& powers, const PartCoefficients& coefficients,
                   const Eigen::Vector3f& per_edge, GradientLanes& points);

}  // namespace sherd
