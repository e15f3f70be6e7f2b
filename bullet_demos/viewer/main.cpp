#include <exception>
#include <iostream>

#include "viewer/arguments.h"
#include "viewer/scripted.h"
#include "viewer/viewer.h"

namespace {

int view(const demo::ViewArguments& arguments) {
    const auto context = arguments.off_screen ? render::Context::offScreen(arguments.size)
                                              : render::Context::inWindow(arguments.size, "Sherd");
    if (arguments.script.steps > 0) {
        const sherd::Status done = demo::runScript(arguments, *context);
        if (!done) std::cerr << done.error() << "\n";
        return done ? 0 : 1;
    }
    std::cout
        << "A window is open. Click: throw a ball. Drag: turn. Right button or G: hold a body. R: again. "
           "Space: pause. The panel lists the other keys (H shows it); close the window to end."
        << std::endl;
    demo::Viewer viewer(arguments, *context);
    viewer.run();
    for (const std::string& message : viewer.errors().messages()) std::cerr << message << "\n";
    return 0;
}

int viewerMain(int argc, const char* const* argv) {
    const auto arguments = demo::parseViewArguments(argc, argv);
    if (!arguments) {
        std::cerr << arguments.error() << "\n";
        return 2;
    }
    if (!arguments.value().help.empty()) {
        std::cout << arguments.value().help;
        return 0;
    }
    return view(arguments.value());
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return viewerMain(argc, argv);
    } catch (const std::exception& failure) {
        std::cerr << "The viewer stopped: " << failure.what() << "\n";
        return 1;
    }
}
