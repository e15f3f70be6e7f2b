#pragma once

#include <utility>
#include <vector>

#include "core/mlpg/particle_forms/stress_problem.h"

namespace sherd {

/// The flux through the faces of every sub-domain P that each particle b makes (paper, Eq. 14), a 3 x 3
/// block:
///     K_Pb = - sum over faces of P of [ lambda n g_b^T + mu g_b n^T + mu (g_b . n) I ] dA,   g_b = grad
///     phi_b.
struct HeavisideBlocks {
    std::vector<std::vector<std::pair<int, Mat3>>>
        rows;  ///< per P: b and K_Pb, ascending in b, P itself included
    EvaluationCounts evaluations{};
};

/// On sub-domains that tile the solid, one quadrature point a face; each face is integrated once and counts
/// for both its sub-domains with opposite signs, so that forces balance to rounding.
HeavisideBlocks fluxThroughSharedFaces(const StressProblem& problem);

/// As the paper does it (section 7): the sub-domain of a particle is its whole cube on the grid, every one of
/// its six faces has 4 x 4 Gauss points with shape functions of their own, and two cubes that share a face
/// integrate it one after the other. A face with no sub-domain beyond it carries the prescribed traction
/// alone (Eq. 16). Exact for linear fields where the cubes fill the solid; where the surface cuts them their
/// size is wrong.
HeavisideBlocks fluxThroughCubes(const StressProblem& problem);

/// One term of K_Pb: the force sigma(phi_b e_j) A through an area A, column j.
inline Mat3 fluxBlock(const Vec3& gradient, const Vec3& area, const Elasticity& elasticity) {
    return elasticity.lambda_pa * area * gradient.transpose() +
           elasticity.mu_pa * gradient * area.transpose() +
           elasticity.mu_pa * gradient.dot(area) * Mat3::Identity();
}

}  // namespace sherd
