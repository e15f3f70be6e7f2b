#pragma once

#include <Eigen/Dense>
#include <stdexcept>

namespace render {

using Vec2 = Eigen::Vector2f;
using Vec3 = Eigen::Vector3f;
using Mat4 = Eigen::Matrix4f;

/// What the graphics driver or the window system cannot do; `what()` is a sentence for the user.
class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Width and height in pixels.
struct Size {
    int width = 0, height = 0;
    float aspect() const { return height > 0 ? float(width) / float(height) : 1; }
    bool operator==(const Size& other) const { return width == other.width && height == other.height; }
    bool operator!=(const Size& other) const { return !(*this == other); }
};

/// A box along the axes.
struct Bounds {
    Vec3 lo = Vec3::Constant(1e30f), hi = Vec3::Constant(-1e30f);
    void add(const Vec3& point) {
        lo = lo.cwiseMin(point);
        hi = hi.cwiseMax(point);
    }
    bool empty() const { return lo.x() > hi.x(); }
    Vec3 centre() const { return (lo + hi) / 2; }
    float radius() const { return empty() ? 0 : (hi - lo).norm() / 2; }
};

}  // namespace render
