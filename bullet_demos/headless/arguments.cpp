#include "headless/arguments.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "scenes/scene_changes.h"
#include "scenes/scene_file.h"
#include "scenes/scenes.h"

namespace demo {

sherd::Result<Arguments> parseArguments(int argc, const char* const* argv) {
    Arguments arguments;
    std::string scene = "coffee_cup", preset, seed;
    std::vector<std::string> assignments;
    bool one_line = false;

    CLI::App app(
        "Runs a scene without a window and writes a report, the fragments and scene files for pictures.");
    app.name("bullet_demos/run");
    app.add_option("SCENE", scene, "Its name, or a scene file that ends in .json")->capture_default_str();
    app.add_option("--preset", preset, "Figures that the scene file has under this name: paper")
        ->type_name("NAME");
    app.add_option("--set", assignments, "Change figures of the scene, see below")
        ->type_name("KEY=VALUE ...");
    app.add_option("--seed", seed, "The same as --set seed=N")->type_name("N");
    app.add_flag("--list", arguments.show_list, "Name the scenes");
    app.add_option("--out", arguments.out, "Folder for what is written")->type_name("DIR");
    app.add_option("--scenes", arguments.scenes, "Folder of the scenes")->type_name("DIR");
    app.add_option("--meshes", arguments.meshes, "Folder that keeps generated meshes")->type_name("DIR");
    app.add_flag("--progress-line", one_line, "Keep the progress on one line of a terminal");
    app.footer("\n" + describeChanges());
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        arguments.help = app.help();
        return arguments;
    } catch (const CLI::ParseError& error) {
        return sherd::Error{std::string(error.what()) + " (see --help)"};
    }

    if (one_line) arguments.progress = Progress::Style::one_line;
    if (arguments.show_list) return arguments;
    if (!seed.empty()) assignments.push_back("seed=" + seed);
    const auto file = sceneFile(scene, arguments.scenes);
    if (!file) return sherd::Error{file.error()};
    auto read = readScene(file.value(), preset, assignments);
    if (!read) return sherd::Error{read.error()};
    arguments.scene = std::move(read).value();
    return arguments;
}

}  // namespace demo
