#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scenes/scene.h"

namespace demo {

// The text of a scene file before it becomes a scene. All throw BadKey.

/// The JSON of a file; comments (`//`, `/* */`) are allowed, a key twice in one object is not.
nlohmann::json parseSceneFile(const std::string& path);

/// Lays one scene over another: objects key by key, lists item by item, null takes a key away.
void layOver(nlohmann::json& scene, const nlohmann::json& changes);

/// Sets one value by its path. `assignment` is as bodies[0].position_m=[0,0,2]; what is no JSON counts as
/// text.
void setByPath(nlohmann::json& scene, const std::string& assignment);

}  // namespace demo
