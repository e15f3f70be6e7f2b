#pragma once

#include "core/linear_algebra/sparse_solver.h"
#include "core/mlpg/splines/spline_space.h"
#include "core/sampling/discretisation.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// Displacement held near zero at a point: stiffness (N/m) against u there.
struct PointSpring {
    int part = -1;
    Vec3 xi = Vec3::Zero();  ///< in the part's cell, edges from its middle
    double stiffness_n_m = 0;
};

/// The same, given by its place.
struct SupportSpring {
    Vec3 position = Vec3::Zero();  ///< m
    double stiffness_n_m = 0;
};
/// Those that lie on the parts of a grid.
std::vector<PointSpring> springsOf(const CellParts& solid, const std::vector<SupportSpring>& supports);

/// Stiffness of the Galerkin form on a spline space, row (a, i), column (b, j):
///     K_ab = int lambda grad phi_a grad phi_b^T + mu grad phi_b grad phi_a^T + mu (grad phi_a . grad phi_b)
///     I dV
///            + sum over springs k phi_a phi_b I,
/// integrated exactly on every part of a cell by its moments; whole cells share one matrix. `share_of_part`
/// scales what each part adds (#parts, or empty: 1). Columns; entries from the diagonal blocks (complete)
/// downwards, in blocks of 3.
SparseMatrix splineStiffness(const CellParts& solid, const SplineSpace& space, const Elasticity& elasticity,
                             const std::vector<PointSpring>& springs,
                             const std::vector<double>& share_of_part = {});

/// The pattern alone, a line for each column of 3 x 3 blocks; no values.
SparseMatrix splinePattern(const CellParts& solid, const SplineSpace& space);

/// The same stiffness between raw functions, without its matrix: forces (3 x raw_count, N) that balance the
/// stresses which raw coefficients `displacement` (m) make.
Eigen::Matrix3Xd splineInternalForces(const CellParts& solid, const SplineSpace& space,
                                      const Elasticity& elasticity, const std::vector<PointSpring>& springs,
                                      const Eigen::Matrix3Xd& displacement);

/// Integrals of phi_a (1, x - origin) of every raw function, 4 x raw_count; `origins` per part.
Eigen::Matrix4Xd splineBodyMoments(const CellParts& solid, const SplineSpace& space,
                                   const std::vector<Vec3>& origins);

/// A x of a symmetric matrix in blocks of 3 as splineStiffness makes it.
Eigen::VectorXd symmetricProduct(const SparseMatrix& lower, const Eigen::VectorXd& x);

}  // namespace sherd
