#pragma once

#include <sherd/sherd.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "headless/scene_run.h"
#include "scenes/scene.h"

namespace demo {

/// The first solved blow of a run, struck again on the same assets.
using FurtherBlows = std::vector<sherd::BlowEvent>;

/// The content of report.json. Wall-clock times are inside `ms` and nowhere else: two runs differ in nothing
/// else.
nlohmann::ordered_json makeReport(const Scene& scene, const SceneAssets& assets, const SceneRun& run,
                                  const FurtherBlows& further_blows);

}  // namespace demo
