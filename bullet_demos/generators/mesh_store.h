#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <functional>
#include <string>

namespace demo {

/// What a generator makes, from `folder`/NAME_TRIANGLES.obj; if that is not there yet, it is made and written
/// there, which `announce` is told. A file that is not what the generator wrote (cut short, or of an older
/// form) is to be deleted by hand.
sherd::Result<sherd::TriangleMesh> storedMesh(const std::string& name, int triangles,
                                              const std::string& folder,
                                              const std::function<void(const std::string&)>& announce);

}  // namespace demo
