#include "render/camera.h"

#include <algorithm>
#include <cmath>

#include "render/projection.h"

namespace render {

namespace {
constexpr float steepest = 1.5f;  ///< radians; straight down has no upright picture
}

void OrbitCamera::frame(const Bounds& bounds, const Vec3& towards, float aspect) {
    const Vec3 along = towards.normalized();
    yaw_ = std::atan2(along.x(), along.y());
    pitch_ = std::clamp(std::asin(along.z()), -steepest, steepest);
    target_ = bounds.centre();
    const float narrow = std::tan(height_rad_ / 2) * std::min(1.0f, aspect);
    distance_ = std::max(0.05f, bounds.radius() / std::sin(std::atan(narrow)));
}

float OrbitCamera::distanceFor(float radius) const {
    return radius / std::sin(height_rad_ / 2);
}

void OrbitCamera::orbit(float yaw_rad, float pitch_rad) {
    yaw_ += yaw_rad;
    pitch_ = std::clamp(pitch_ + pitch_rad, -steepest, steepest);
}

void OrbitCamera::pan(float right, float up) {
    const Mat4 view = this->view();
    const float height = 2 * distance_ * std::tan(height_rad_ / 2);
    target_ += height * (right * view.block<1, 3>(0, 0) + up * view.block<1, 3>(1, 0)).transpose();
}

void OrbitCamera::zoom(float factor) {
    distance_ = std::clamp(distance_ * factor, 0.02f, 200.0f);
}

Vec3 OrbitCamera::forward() const {
    const float level = std::cos(pitch_);
    return Vec3(level * std::sin(yaw_), level * std::cos(yaw_), std::sin(pitch_));
}

Mat4 OrbitCamera::view() const {
    return lookAt(eye(), target_, Vec3::UnitZ());
}

Mat4 OrbitCamera::projection(float aspect) const {
    return perspective(height_rad_, aspect, distance_ / 50, distance_ * 20 + 20);
}

Ray OrbitCamera::ray(float x, float y, float aspect) const {
    const float top = std::tan(height_rad_ / 2);
    const Vec3 through((2 * x - 1) * top * aspect, (1 - 2 * y) * top, -1);
    return {eye(), (view().block<3, 3>(0, 0).transpose() * through).normalized()};
}

}  // namespace render
