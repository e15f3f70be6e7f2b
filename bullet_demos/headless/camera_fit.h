#pragma once

#include <sherd/types.h>

#include <vector>

#include "scenes/scene.h"

namespace demo {

/// A placed camera, as POV-Ray takes it.
struct Viewpoint {
    Vec3 position = Vec3::Zero();
    Vec3 look_at = Vec3::Zero();
    Vec3 up = Vec3::UnitZ();
    double width_deg = 30;
};

/// The nearest place, looking along the camera's direction, from which the points of all bodies but far
/// strays are in the picture with a margin. No body is without points; `aspect` is width over height.
Viewpoint fitCamera(const Camera& camera, const std::vector<std::vector<Vec3>>& bodies, double aspect);

}  // namespace demo
