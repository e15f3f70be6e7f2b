#pragma once

#include <Eigen/Dense>

namespace sherd {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Symmetric tensor as (xx, yy, zz, xy, yz, zx); shear components are those of the tensor, not doubled.
using Voigt = Eigen::Matrix<double, 6, 1>;

/// A force at a point of a body: one quadrature point of a traction. Asset frame; position in m, force in N.
struct PointForce {
    Vec3 position = Vec3::Zero();
    Vec3 force = Vec3::Zero();
};

}  // namespace sherd
