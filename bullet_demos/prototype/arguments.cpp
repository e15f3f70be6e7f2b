#include "prototype/arguments.h"

#include <CLI/CLI.hpp>

namespace prototype {

sherd::Result<Arguments> parseArguments(int argc, const char* const* argv) {
    Arguments arguments;
    CLI::App app(
        "A game of breaking things. Click: throw a ball. Space: bomb. Right button: look around. Esc: "
        "leave.");
    app.name("bullet_demos/run --play");
    app.add_option("--baked", arguments.baked, "Folder that keeps what takes long to make")->type_name("DIR");
    app.add_option("--width", arguments.size.width, "Of the picture, pixels")->check(CLI::Range(64, 8192));
    app.add_option("--height", arguments.size.height, "Of the picture, pixels")->check(CLI::Range(64, 8192));
    app.add_flag("--off-screen", arguments.off_screen, "Open no window; needs --script-seconds");
    app.add_option(
           "--script-seconds", arguments.script_seconds,
           "Play so long in the game's own time without hands, then end; it takes longer where pictures are "
           "drawn slowly, as without a graphics card")
        ->check(CLI::Range(0.1, 86400.0));
    app.add_flag("--paced", arguments.paced, "The script keeps to real time");
    app.add_option("--screenshot", arguments.screenshot, "Write the script's last picture there (PNG)")
        ->type_name("FILE");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        arguments.help = app.help();
        return arguments;
    } catch (const CLI::ParseError& error) {
        return sherd::Error{std::string(error.what()) + " (see --help)"};
    }
    const bool is_scripted = arguments.script_seconds > 0;
    if (!is_scripted && (arguments.off_screen || arguments.paced || !arguments.screenshot.empty()))
        return sherd::Error{"Without hands it takes a time to play: add --script-seconds N."};
    return arguments;
}

}  // namespace prototype
