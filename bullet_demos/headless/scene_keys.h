#pragma once

#include <sherd/result.h>

#include <string>
#include <vector>

#include "scenes/scene.h"

namespace demo {

/// Changes one figure of a scene. `assignment` is KEY=VALUE; the error lists the keys there are, or the
/// values that the key takes.
sherd::Status applyKey(Scene& scene, const std::string& assignment);

/// One line a key, for --help.
std::string describeKeys();

}  // namespace demo
