#pragma once

#include "core/linear_algebra/sparse_matrix.h"
#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// The mass matrix at unit density, M_ab = int phi_a phi_b dV, m^3, between functions that carry unknowns:
/// the same in x, y and z. Consistent, by the quadrature that builds K. In CSC, the lower half.
SparseMatrix splineMass(const CellParts& solid, const SplineSpace& space);

/// M u of displacements, 3 #functions x any count.
Eigen::MatrixXd massProduct(const SparseMatrix& mass, const Eigen::MatrixXd& displacements);

}  // namespace sherd
