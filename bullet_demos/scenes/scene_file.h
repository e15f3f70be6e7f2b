#pragma once

#include <sherd/result.h>

#include <string>
#include <vector>

#include "scenes/scene.h"

namespace demo {

/// Reads a scene file (scenes/README.md says what it holds). `preset` names one of its presets, which is laid
/// over the rest; then come `changes`, one after the other (scenes/scene_changes.h): "strength=2e6",
/// "bodies[0].position_m=[0,0,2]". The error is a sentence with the file, the path of the key and what is
/// possible there.
sherd::Result<Scene> readScene(const std::string& path, const std::string& preset = "",
                               const std::vector<std::string>& changes = {});

}  // namespace demo
