#pragma once

#include <sherd/result.h>

#include <string>
#include <vector>

#include "film/recording.h"

namespace demo {

/// Writes a whole run as a binary glTF 2.0 with one animation, for Blender and other programs. Every body,
/// fragment and ball is a node; it has size 0 before it is born and after it was replaced. The error names
/// the file.
sherd::Status writeGltf(const std::vector<Track>& tracks, const std::string& path);

}  // namespace demo
