#pragma once

#include "core/linear_algebra/block_matrix.h"
#include "core/mlpg/particle_forms/cell_gradients.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// Stiffness of the Galerkin form on smoothed strains, row (a, i), column (b, j):
///     K_ab = sum_c V_c [ lambda g_ca g_cb^T + mu g_cb g_ca^T + mu (g_ca . g_cb) I ].
/// A block is that of a pair of particles.
BlockMatrix galerkinStiffness(const Discretisation& solid, const CellGradients& cells,
                              const Elasticity& elasticity);

}  // namespace sherd
