#pragma once

#include <sherd/result.h>

#include <string>
#include <vector>

#include "scenes/scene.h"
#include "world/placed_scene.h"

namespace demo {

/// Writes a scene file for POV-Ray 3.7 from the surfaces of the bodies as they stand. Lights, floor and
/// finishes come from look.inc beside this file. The camera takes in every breakable body; balls are in the
/// picture where they happen to be.
sherd::Status writePov(const std::vector<BodyState>& states, const Camera& camera, const std::string& path);

}  // namespace demo
