#pragma once

#include "core/linear_algebra/sparse_matrix.h"
#include "core/mlpg/particle_forms/heaviside_blocks.h"

namespace sherd {

/// Stiffness of MLPG5 (paper, Eq. 14), bordered by the rigid motions, which are removed by multipliers (6 a
/// component, last rows and columns):
///     [ K    V R ] [u]   [f]
///     [ R^T V  0 ] [m] = [0],   K: HeavisideBlocks, V: volume of the sub-domain.
/// Row (P, i), column (b, j), in CSR. One function a particle (mls).
SparseMatrix heavisideStiffness(const HeavisideBlocks& blocks, const Discretisation& solid,
                                const RigidMotions& motions);

}  // namespace sherd
