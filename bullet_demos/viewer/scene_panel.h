#pragma once

#include <string>
#include <vector>

#include "viewer/state.h"

namespace demo {

/// The panel on the left: what is shown, how it breaks, what is thrown, and what is drawn over it.
/// `scene_files` are those to choose from.
void drawScenePanel(ViewerState& state, const std::vector<std::string>& scene_files);

}  // namespace demo
