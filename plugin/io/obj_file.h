#pragma once

#include <sherd/triangle_mesh.h>

#include <string>
#include <string_view>

namespace sherd {

/// The text of an OBJ file as a mesh, before vertices are merged. `name` stands for the file in error
/// sentences.
Result<TriangleMesh> parseObj(std::string_view text, const std::string& name);

}  // namespace sherd
