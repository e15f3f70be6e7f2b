#pragma once

#include <Eigen/Dense>

namespace sherd {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// A symmetric tensor as (xx, yy, zz, xy, yz, zx), for stresses. Shear components are those of the tensor,
/// not doubled.
using SymmetricTensor = Eigen::Matrix<double, 6, 1>;

/// A force at a point of a body: a traction on a piece of its surface, taken together. In the
/// coordinates of the body's surface; position in m, force in N.
struct PointForce {
    Vec3 position = Vec3::Zero();
    Vec3 force = Vec3::Zero();
};

}  // namespace sherd
