#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace demo {

/// Changes one value of a scene before it is read. `assignment` is PATH=VALUE, as
/// bodies[0].position_m=[0,0,2], or KEY=VALUE with one of a few short keys; [*] in a path is every item of a
/// list. What is no JSON counts as text. Throws BadKey.
void changeScene(nlohmann::json& scene, const std::string& assignment);

/// The short keys and all paths with what they take, for --help.
std::string describeChanges();

}  // namespace demo
