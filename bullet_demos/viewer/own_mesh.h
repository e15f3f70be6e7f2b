#pragma once

#include "viewer/loading.h"

namespace demo {

/// A mesh of the user's own as the only body of a scene, above the floor. The error is the library's sentence
/// about the mesh, with the name of the file.
sherd::Result<Loaded> loadOwnMesh(const Choices& choices);

}  // namespace demo
