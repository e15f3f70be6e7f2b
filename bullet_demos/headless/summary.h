#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "headless/scene_run.h"

namespace demo {

/// A report for people: one table of stages with counts and milliseconds, what the blows did, and what went
/// wrong.
std::string summarise(const SceneRun& run, const nlohmann::ordered_json& report);

}  // namespace demo
