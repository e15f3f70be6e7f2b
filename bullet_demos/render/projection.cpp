#include "render/projection.h"

#include <cmath>

namespace render {

Mat4 lookAt(const Vec3& eye, const Vec3& at, const Vec3& up) {
    const Vec3 back = (eye - at).normalized(), right = up.cross(back).normalized(), top = back.cross(right);
    Mat4 view = Mat4::Identity();
    view.block<1, 3>(0, 0) = right.transpose();
    view.block<1, 3>(1, 0) = top.transpose();
    view.block<1, 3>(2, 0) = back.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye;
    return view;
}

Mat4 perspective(float height_rad, float aspect, float near, float far) {
    const float scale = 1 / std::tan(height_rad / 2);
    Mat4 projection = Mat4::Zero();
    projection(0, 0) = scale / aspect;
    projection(1, 1) = scale;
    projection(2, 2) = (far + near) / (near - far);
    projection(2, 3) = 2 * far * near / (near - far);
    projection(3, 2) = -1;
    return projection;
}

Mat4 orthographic(float half_width, float half_height, float near, float far) {
    Mat4 projection = Mat4::Identity();
    projection(0, 0) = 1 / half_width;
    projection(1, 1) = 1 / half_height;
    projection(2, 2) = 2 / (near - far);
    projection(2, 3) = (far + near) / (near - far);
    return projection;
}

Vec3 transformed(const Mat4& transform, const Vec3& point) {
    return (transform * point.homogeneous()).hnormalized();
}

}  // namespace render
