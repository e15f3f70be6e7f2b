#pragma once

#include <sherd/repair.h>
#include <sherd/result.h>
#include <sherd/settings.h>

#include <string>

#include "cli/bake_command.h"

namespace sherd::cli {

/// What the command line asks for.
struct Arguments {
    enum class Command { stress, bake };
    Command command = Command::stress;
    BakeArguments bake;  ///< of `sherd bake`; all below is of `sherd stress`, but for `help`

    std::string case_file;
    std::string points;  ///< CSV of the points to evaluate; empty: particles and surface points
    std::string out;     ///< CSV of the stresses
    std::string report;  ///< JSON; empty: none
    std::string vtk;     ///< .vtk or .vtu; empty: none
    std::string quality = "game";
    Settings settings;  ///< of the quality, with what other options change
    Repair repair;      ///< how the case's mesh is taken in
    std::string help;   ///< the text to show and leave, if asked for
};

/// Reads the command line; the error is a sentence with the choices there are.
Result<Arguments> parseArguments(int argc, const char* const* argv);

}  // namespace sherd::cli
