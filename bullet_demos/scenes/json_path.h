#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace demo {

/// What a list is where it is left out, by its key; null where that is not known.
using DefaultList = nlohmann::json (*)(const std::string& key);

/// Sets the value at a path as bodies[0].position_m[2]; [*] is every item of a list. Objects on the way that
/// are not there are made. Throws BadKey where the path leads nowhere.
void setAtPath(nlohmann::json& root, const std::string& path, const nlohmann::json& value,
               DefaultList default_list);

}  // namespace demo
