#pragma once

#include <sherd/sherd.h>

#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace demo {

/// The assets of a scene's breakable bodies, checked and sampled; they outlive runs, so that a second run
/// finds them factored.
struct SceneAssets {
    std::vector<sherd::BreakableAsset> bodies;
    double sample_ms = 0;  ///< wall-clock time of sampling them
};

/// Generated meshes are kept in the folder `meshes`; what takes long is said to `announce`.
sherd::Result<SceneAssets> makeAssets(const Scene& scene, const std::string& meshes,
                                      const std::function<void(const std::string&)>& announce);

}  // namespace demo
