#pragma once

#include <sherd/result.h>

#include <optional>
#include <string>
#include <vector>

#include "render/types.h"
#include "viewer/state.h"

namespace demo {

/// A throw without hands.
struct PlannedThrow {
    int step = 1;                    ///< before which it is thrown
    render::Vec2 at = {0.5f, 0.5f};  ///< of the picture, from its upper left corner
    bool at_body = false;            ///< at the middle of the bodies instead
};

/// What happens without hands; no steps: everything is up to the user.
struct Script {
    int steps = 0;
    std::vector<PlannedThrow> throws;
    std::string screenshot;  ///< file of the picture after the last step; empty: none
    std::string frames;      ///< folder of pictures; empty: none
    int steps_per_frame = 4;
    bool panels = false;  ///< in the pictures
};

/// What the command line asks for.
struct ViewArguments {
    ViewerState state;
    std::vector<std::string> scene_files;
    std::string meshes = "out/meshes";  ///< folder that keeps generated meshes
    std::string pictures = ".";         ///< folder of pictures that keys ask for
    render::Size size{1280, 800};
    std::optional<int> samples;  ///< a pixel; none: as the driver can
    bool off_screen = false;
    bool prepare = true;
    float zoom = 1;  ///< multiplies the camera's distance
    Script script;
    std::string help;  ///< the text to show and leave, if asked for
};

/// Reads the command line; the error is a sentence.
sherd::Result<ViewArguments> parseViewArguments(int argc, const char* const* argv);

}  // namespace demo
