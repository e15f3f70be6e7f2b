#pragma once

#include <sherd/types.h>

#include <Eigen/Dense>
#include <vector>

namespace sherd {

/// Uniform B-splines of degree p on one cell: tensor products of the p + 1 pieces that differ from zero there
/// in each direction, x fastest. `xi` is a point of the cell, from its middle in edges; the pieces are
/// polynomials, so beyond the cell they go on. Values and derivatives by xi:
void splineValues(int degree, const Vec3& xi, std::vector<double>& values);
void splineGradients(int degree, const Vec3& xi, std::vector<Vec3>& gradients);

/// The pieces in one direction as polynomials: (k, a) is the factor of xi^k in piece a.
Eigen::MatrixXd splinePowers(int degree);

}  // namespace sherd
