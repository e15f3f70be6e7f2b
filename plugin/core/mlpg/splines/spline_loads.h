#pragma once

#include <sherd/types.h>

#include "core/mlpg/splines/spline_field.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// A body force that is an affine function of place, N/m^3: value + gradient (x - about).
struct AffineForce {
    Vec3 value = Vec3::Zero();
    Mat3 gradient = Mat3::Zero();
    Vec3 about = Vec3::Zero();
};

/// Everything that acts on a body.
struct BodyLoads {
    std::vector<PointForce> forces;
    std::vector<AffineForce> body_forces;  ///< per part of the grid that they are given for
};

/// Adds point forces to the forces at the raw functions (3 x raw_count, N). False if one of them lies further
/// than a cell from the solid; those before it are added.
bool addPointForces(const CellParts& solid, const SplineSpace& space, const std::vector<PointForce>& loads,
                    Eigen::Matrix3Xd& raw);

/// Body forces at the raw functions, 3 x raw_count, N.
Eigen::Matrix3Xd bodyForcesAt(const CellParts& solid, const SplineSpace& space,
                              const std::vector<AffineForce>& body_forces);

/// Those of a coarser grid's loads that act on a finer grid of a part of the body. `parents`: see
/// parentParts. A part without a parent is under the body force of its component.
BodyLoads loadsInside(const CellParts& fine, const SplineSpace& fine_space, const std::vector<int>& parents,
                      const BodyLoads& coarse);

}  // namespace sherd
