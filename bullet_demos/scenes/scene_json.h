#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace demo {

// The text of a scene file before it becomes a scene. All throw BadKey.

/// The JSON of a file; comments (`//`, `/* */`) are allowed, a key twice in one object is not.
nlohmann::json parseSceneFile(const std::string& path);

/// Lays one scene over another: objects key by key, lists item by item, null takes a key away.
void layOver(nlohmann::json& scene, const nlohmann::json& changes);

/// A value from the command line; what is no JSON counts as text.
nlohmann::json parseSceneValue(const std::string& text);

}  // namespace demo
