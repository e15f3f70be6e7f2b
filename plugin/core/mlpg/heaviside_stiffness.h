#pragma once

#include "core/linear_algebra/sparse_solver.h"
#include "core/mlpg/cell_gradients.h"
#include "core/mlpg/rigid_motions.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// Stiffness of MLPG5 (paper, Eq. 14) on sub-domains that tile the solid, one quadrature point a face; each
/// face is integrated once and counts for both its sub-domains with opposite signs, so that forces balance to
/// rounding. Row (P, i), column (b, j):
///     K_Pb = - sum over faces of P of [ lambda n g_b^T + mu g_b n^T + mu (g_b . n) I ] dA,   g_b = grad
///     phi_b,
/// bordered by the rigid motions, which are removed by multipliers (6 a component, last rows and columns):
///     [ K    V R ] [u]   [f]
///     [ R^T V  0 ] [m] = [0],   V: volume of the sub-domain.
/// Rows. One function a particle (mls).
struct HeavisideStiffness {
    SparseMatrix matrix;
    EvaluationCounts evaluations{};
};
HeavisideStiffness heavisideStiffness(const Discretisation& solid, const SupportGraph& supports,
                                      const TrialSpace& space, const Elasticity& elasticity,
                                      const RigidMotions& motions);

}  // namespace sherd
