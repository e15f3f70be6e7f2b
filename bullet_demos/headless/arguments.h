#pragma once

#include <sherd/result.h>

#include <string>

#include "film/frame_files.h"
#include "headless/progress.h"
#include "scenes/scene.h"

namespace demo {

/// What the command line asks for.
struct Arguments {
    Scene scene;                                 ///< with the changes of --preset, --set and --seed
    std::string scenes = "bullet_demos/scenes";  ///< folder of the scenes that are called by name
    std::string meshes = "out/meshes";           ///< folder that keeps generated meshes
    std::string out = "out";  ///< the scene's files go into a folder of its name below this one
    Film film;                ///< with a folder, if frames are asked for
    std::string gltf;         ///< file for an animation of the whole run; empty: none
    Progress::Style progress = Progress::Style::few_lines;
    bool show_list = false;
    std::string help;  ///< the text to show and leave, if asked for
};

/// Reads the command line; the error is a sentence with the choices there are.
sherd::Result<Arguments> parseArguments(int argc, const char* const* argv);

}  // namespace demo
