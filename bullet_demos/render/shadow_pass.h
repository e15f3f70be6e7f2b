#pragma once

#include "render/camera.h"
#include "render/frame.h"
#include "render/target.h"

namespace render {

/// The shadows of the sun: one map, seen along the sunlight, of all that is near what the camera looks at.
class ShadowPass {
  public:
    void draw(const Frame& frame, const OrbitCamera& camera);

    const Mat4& toShadow() const { return to_shadow_; }  ///< from the world to the map
    void bindDepth(int unit) const { map_.bindDepth(unit); }

  private:
    Program program_{"shadow.vert", "shadow.frag"};
    ShadowMap map_{2048};
    Mat4 to_shadow_ = Mat4::Identity();
};

}  // namespace render
