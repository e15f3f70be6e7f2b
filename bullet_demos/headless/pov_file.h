#pragma once

#include <sherd/result.h>

#include <iosfwd>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "world/placed_scene.h"

namespace demo {

/// Writes a scene file for POV-Ray 3.7 from the surfaces of the bodies as they stand. Lights, floor and
/// finishes come from look.inc beside this file. The camera takes in every breakable body; balls are in the
/// picture where they happen to be.
sherd::Status writePov(const std::vector<BodyState>& states, const Camera& camera, const std::string& path);

// The parts of such a file, for films.

/// A film does without light that goes from surface to surface: from frame to frame it would flicker.
enum class PovStyle { still, film };

/// Version, lights, floor and the camera, which takes in the breakable ones of `states`.
void writePovStage(std::ostream& out, const std::vector<BodyState>& states, const Camera& camera,
                   PovStyle style);

/// A body or ball where it stands, as one object.
void writePovBody(std::ostream& out, const BodyState& state);

}  // namespace demo
