#pragma once

#include <Eigen/Dense>

namespace sherd {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// A symmetric tensor as (xx, yy, zz, xy, yz, zx), for stresses. Shear components are those of the tensor,
/// not doubled. Their order is not Voigt's (yz, zx, xy).
using SymmetricTensor = Eigen::Matrix<double, 6, 1>;

/// A force at a point of a body, which stands for the traction on a piece of its surface. Asset frame: the
/// coordinates that the body's surface is given in. Position in m, force in N.
struct PointForce {
    Vec3 position = Vec3::Zero();
    Vec3 force = Vec3::Zero();
};

}  // namespace sherd
