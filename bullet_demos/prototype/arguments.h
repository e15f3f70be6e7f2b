#pragma once

#include <sherd/result.h>

#include <string>

#include "render/types.h"

namespace prototype {

/// What the command line asks for.
struct Arguments {
    std::string baked = "out/play";  ///< folder that keeps what takes long to make
    render::Size size{1280, 720};
    bool off_screen = false;
    double script_seconds = 0;  ///< 0: somebody plays
    bool paced = false;         ///< the script keeps to real time
    std::string screenshot;     ///< file of the script's last picture
    std::string help;           ///< the text to show and leave, if asked for
};

/// Reads the command line; the error is a sentence.
sherd::Result<Arguments> parseArguments(int argc, const char* const* argv);

}  // namespace prototype
