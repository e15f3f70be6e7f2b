#pragma once

#include "core/mlpg/particle_forms/cell_gradients.h"

namespace sherd {

/// Displacement gradient (row i, column j: du_i/dx_j) of every cell for unknowns u laid out as in TrialSpace.
std::vector<Mat3> displacementGradients(const CellGradients& cells, const Eigen::VectorXd& u);

/// sum_c V_c g_ca . sigma_c for every function a: the forces at the unknowns that stresses sigma_c
/// (symmetric) balance.
Eigen::VectorXd internalForces(const Discretisation& solid, const CellGradients& cells,
                               const std::vector<Mat3>& stresses, long unknowns);

}  // namespace sherd
