#pragma once

#include <sherd/result.h>

#include <nlohmann/json.hpp>
#include <string>

#include "headless/scene_run.h"
#include "scenes/scene.h"

namespace demo {

/// Writes report.json, one OBJ a fragment (in the coordinates of the body that broke: together they are that
/// body again) and the scene files of the pictures into `folder`; what an earlier run left of these is
/// deleted first.
sherd::Status writeOutputs(const Scene& scene, const SceneRun& run, const nlohmann::ordered_json& report,
                           const std::string& folder);

}  // namespace demo
