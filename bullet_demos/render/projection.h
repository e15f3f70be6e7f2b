#pragma once

#include "render/types.h"

namespace render {

// Matrices as OpenGL wants them: the view looks along -z, depth goes from -1 to 1.

Mat4 lookAt(const Vec3& eye, const Vec3& at, const Vec3& up);
/// `height_rad` is the vertical opening.
Mat4 perspective(float height_rad, float aspect, float near, float far);
Mat4 orthographic(float half_width, float half_height, float near, float far);

/// Where a homogeneous transform puts a point.
Vec3 transformed(const Mat4& transform, const Vec3& point);

}  // namespace render
