#pragma once

#include "render/types.h"

namespace render {

/// A ray in the world; the direction has unit length.
struct Ray {
    Vec3 origin = Vec3::Zero(), direction = Vec3::UnitY();
};

/// A camera that turns about the point it looks at; z is up.
class OrbitCamera {
  public:
    /// Looks along `towards` so that the ball of `bounds` fills the picture.
    void frame(const Bounds& bounds, const Vec3& towards, float aspect);

    /// From which a ball of that radius about what it looks at fills the picture's height.
    float distanceFor(float radius) const;

    void orbit(float yaw_rad, float pitch_rad);
    /// Moves in the picture's plane, in fractions of its height.
    void pan(float right, float up);
    void moveTarget(const Vec3& way) { target_ += way; }
    /// Multiplies the distance.
    void zoom(float factor);

    Vec3 eye() const { return target_ - distance_ * forward(); }
    Vec3 forward() const;
    Vec3 target() const { return target_; }
    float distance() const { return distance_; }
    Mat4 view() const;
    Mat4 projection(float aspect) const;

    /// Through a point of the picture: x from 0 on the left to 1, y from 0 at the top to 1.
    Ray ray(float x, float y, float aspect) const;

  private:
    Vec3 target_ = Vec3::Zero();
    float distance_ = 3;
    float yaw_ = 0.5f, pitch_ = -0.4f;  ///< of the viewing direction
    float height_rad_ = 0.6f;           ///< vertical opening
};

}  // namespace render
