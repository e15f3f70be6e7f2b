#pragma once

#include <sherd/result.h>

#include <string>
#include <vector>

namespace demo {

/// The paths of all scene files in a folder, by name.
std::vector<std::string> sceneFiles(const std::string& folder);

/// The scene file that is meant by `name`: a path that ends in .json, or the name of one in `folder`. The
/// error lists the names there are.
sherd::Result<std::string> sceneFile(const std::string& name, const std::string& folder);

}  // namespace demo
