#pragma once

#include <sherd/result.h>

#include "core/mlpg/rigid_motions.h"
#include "core/mlpg/splines/spline_space.h"
#include "core/mlpg/stress_solver.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// Stiffness against the displacement of a point of the body.
struct SupportSpring {
    Vec3 position = Vec3::Zero();  ///< m
    double stiffness_n_m = 0;
};

/// The same on a grid.
struct PointSpring {
    int part = -1;
    Vec3 xi = Vec3::Zero();  ///< in the part's cell, edges from its middle
    double stiffness_n_m = 0;
};
/// Those that lie on the parts of a grid.
std::vector<PointSpring> springsOf(const CellParts& solid, const std::vector<SupportSpring>& supports);

/// Springs that hold the displacement near zero where a body is anchored (paper, Eq. 3 and 15). An error if
/// one lies beside the solid.
Result<std::vector<SupportSpring>> supportSprings(const CellParts& solid, const Elasticity& elasticity,
                                                  const std::vector<SupportPoint>& points);

/// Per component, whether springs hold it. An error if they leave it free to turn: those of a point or of a
/// line do.
Result<std::vector<char>> heldComponents(const CellParts& solid, const SplineSpace& space,
                                         const RigidMotions& motions,
                                         const std::vector<SupportSpring>& supports);

}  // namespace sherd
