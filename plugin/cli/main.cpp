#include <exception>
#include <iostream>

#include "cli/arguments.h"
#include "cli/mesh_options.h"
#include "cli/stress_command.h"

int main(int argc, char** argv) {
    try {
        const auto arguments = sherd::cli::parseArguments(argc, argv);
        if (!arguments) {
            std::cerr << arguments.error() << "\n";
            return 2;
        }
        if (!arguments.value().help.empty()) {
            std::cout << arguments.value().help;
            return 0;
        }
        const bool bakes = arguments.value().command == sherd::cli::Arguments::Command::bake;
        const sherd::Status done = bakes ? sherd::cli::runBake(arguments.value().bake, std::cout)
                                         : sherd::cli::runStress(arguments.value(), std::cout);
        if (!done) std::cerr << sherd::cli::withOptions(done.error()) << "\n";
        return done ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "sherd stopped: " << failure.what() << "\n";
        return 1;
    }
}
