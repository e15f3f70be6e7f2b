#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <string>
#include <vector>

namespace sherd::generators {

/// The names that `generate` knows.
std::vector<std::string> generatorNames();

/// The closed surface of the solid of that name in `triangles` triangles within 1 %: the same at every call.
/// Takes some seconds. The error says which name is not known, or which counts are possible.
Result<TriangleMesh> generate(const std::string& name, int triangles);

}  // namespace sherd::generators
