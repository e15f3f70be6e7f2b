#include "arguments.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "scene_keys.h"
#include "scenes/scenes.h"

namespace demo {

sherd::Result<Arguments> parseArguments(int argc, const char* const* argv) {
    Arguments arguments;
    std::string scene = "coffee_cup", seed;
    std::vector<std::string> assignments;
    bool one_line = false;

    CLI::App app(
        "Runs a scene without a window and writes a report, the fragments and scene files for pictures.");
    app.name("bullet_demos/run");
    app.add_option("SCENE", scene, "Which scene")->capture_default_str();
    app.add_option("--set", assignments, "Change figures of the scene, see below")
        ->type_name("KEY=VALUE ...");
    app.add_option("--seed", seed, "The same as --set seed=N")->type_name("N");
    app.add_flag("--list", arguments.show_list, "Name the scenes");
    app.add_option("--out", arguments.out, "Folder for what is written")->type_name("DIR");
    app.add_option("--assets", arguments.assets, "Folder of the meshes")->type_name("DIR");
    app.add_flag("--progress-line", one_line, "Keep the progress on one line of a terminal");
    app.footer("\n" + describeKeys());
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        arguments.help = app.help();
        return arguments;
    } catch (const CLI::ParseError& error) {
        return sherd::Error{std::string(error.what()) + " (see --help)"};
    }

    if (one_line) arguments.progress = Progress::Style::one_line;
    auto found = sceneNamed(scene);
    if (!found) return sherd::Error{found.error()};
    arguments.scene = std::move(found).value();
    if (!seed.empty()) assignments.push_back("seed=" + seed);
    for (const std::string& assignment : assignments) {
        const sherd::Status applied = applyKey(arguments.scene, assignment);
        if (!applied) return sherd::Error{applied.error()};
    }
    return arguments;
}

}  // namespace demo
