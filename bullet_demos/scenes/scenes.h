#pragma once

#include <sherd/result.h>

#include <string>
#include <vector>

#include "scene.h"

namespace demo {

/// All scenes, in the order in which --list shows them.
std::vector<Scene> allScenes();

/// The scene of that name; the error lists the names there are.
sherd::Result<Scene> sceneNamed(const std::string& name);

}  // namespace demo
