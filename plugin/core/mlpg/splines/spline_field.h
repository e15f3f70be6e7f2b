#pragma once

#include <memory>

#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// A displacement in splines on the parts of a solid.
struct SplineField {
    std::shared_ptr<const CellParts> parts;
    std::shared_ptr<const SplineSpace> space;
    Eigen::Matrix3Xd raw;  ///< coefficients of all functions, 3 x raw_count, m
    /// Projected volumetric strain, see VolumetricProjection::dilatation; empty: that of the displacement.
    Eigen::MatrixXd dilatation;
    double projected_share = 0;  ///< see projectedShare
};

/// Degree of the polynomials of projected volumetric strain, for splines of a degree.
constexpr int dilatationDegree(int degree) {
    return degree > 2 ? degree - 1 : 1;
}

/// Gives a displacement gradient the trace with which Hooke's law makes the stress
///     lambda projected I + mu (gradient + gradient^T)
/// of it. `share`: see projectedShare.
template <class Gradient, class Scalar>
void projectTrace(Gradient&& gradient, Scalar projected, Scalar share) {
    gradient.diagonal().array() += share * (projected - gradient.trace()) / 3;
}

/// Displacement gradient of a field on a part, `xi` in its cell, edges from the middle; where the volumetric
/// strain is projected, see projectTrace.
Mat3 gradientOn(const SplineField& field, int part, const Vec3& xi);

/// A point in a solid's grid: found once, read after every solve.
struct GridPoint {
    int part = -1;           ///< nearest to the point; -1: none is near
    Vec3 xi = Vec3::Zero();  ///< in the part's cell, edges from its middle
};
GridPoint locate(const CellParts& solid, const Vec3& x);

}  // namespace sherd
