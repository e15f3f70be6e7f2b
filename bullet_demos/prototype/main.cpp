#include <exception>
#include <iostream>

#include "prototype/arguments.h"
#include "prototype/play.h"
#include "prototype/script.h"

namespace {

int prototypeMain(int argc, const char* const* argv) {
    const auto parsed = prototype::parseArguments(argc, argv);
    if (!parsed) {
        std::cerr << parsed.error() << "\n";
        return 2;
    }
    const prototype::Arguments& arguments = parsed.value();
    if (!arguments.help.empty()) {
        std::cout << arguments.help;
        return 0;
    }
    const auto context = arguments.off_screen ? render::Context::offScreen(arguments.size)
                                              : render::Context::inWindow(arguments.size, "Sherd");
    const bool is_scripted = arguments.script_seconds > 0;
    if (!is_scripted)
        std::cout
            << "A window is open; the first time things are baked in it for a minute or more. Click: throw a "
               "ball. Space: bomb. Right button: look around. Esc: leave."
            << std::endl;
    const sherd::Status done =
        is_scripted ? prototype::playScript(arguments, *context) : prototype::play(arguments, *context);
    if (!done) std::cerr << done.error() << "\n";
    return done ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return prototypeMain(argc, argv);
    } catch (const std::exception& failure) {
        std::cerr << "The game stopped: " << failure.what() << "\n";
        return 1;
    }
}
