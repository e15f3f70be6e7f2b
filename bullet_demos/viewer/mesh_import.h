#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <string>

namespace demo {

/// Reads a mesh of any format that assimp knows (STL, PLY, OFF, glTF and others): all its parts as one
/// surface, in the file's own units and axes, vertices at one place joined. Wavefront OBJ is read by
/// sherd::readObj. The error names the file.
sherd::Result<sherd::TriangleMesh> importMesh(const std::string& path);

/// The axis that points up in files of that format: y in glTF, z otherwise.
sherd::UpAxis usualUpAxis(const std::string& path);

}  // namespace demo
