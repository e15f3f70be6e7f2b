#include "headless/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "scenes/scene_changes.h"
#include "scenes/scene_file.h"
#include "scenes/scenes.h"

namespace demo {

namespace {

void addFilmOptions(CLI::App& app, Arguments& arguments) {
    Film& film = arguments.film;
    auto* frames = app.add_option("--frames", film.folder,
                                  "Draw a film of the whole run: its pictures go into this folder, the film "
                                  "beside the report as SCENE.webp");
    frames->type_name("DIR");
    app.add_option("--fps", film.pace.frames_per_second, "Pictures a second of the film")
        ->needs(frames)
        ->check(CLI::Range(1.0, 240.0))
        ->capture_default_str();
    app.add_option("--slow", film.pace.slow, "How many times slower the film is around the first break")
        ->needs(frames)
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    app.add_option("--frame-width", film.width, "Pixels; the height is 10/16 of it")
        ->needs(frames)
        ->check(CLI::Range(32, 4096))
        ->capture_default_str();
    // What the program writes is the same with it and without: the script that calls it draws the pictures.
    app.add_flag("--povray", "Draw the pictures beside the report also where a film is drawn");
    app.add_option("--gltf", arguments.gltf, "Write the whole run as an animated glTF 2.0 (a .glb)")
        ->type_name("FILE");
}

}  // namespace

sherd::Result<Arguments> parseArguments(int argc, const char* const* argv) {
    Arguments arguments;
    std::string scene = "coffee_cup", preset, seed;
    std::vector<std::string> assignments;
    bool one_line = false;

    CLI::App app(
        "Runs a scene without a window and writes a report, the fragments and scene files for pictures.");
    app.name("bullet_demos/run");
    const CLI::Option* const named =
        app.add_option("SCENE", scene, "Its name, or a scene file that ends in .json")->capture_default_str();
    app.add_option("--preset", preset, "Figures that the scene file has under this name: paper")
        ->type_name("NAME");
    app.add_option("--set", assignments, "Change figures of the scene; --help-all lists them")
        ->type_name("KEY=VALUE ...");
    app.add_option("--seed", seed, "The same as --set seed=N")->type_name("N");
    app.add_flag("--list", arguments.show_list, "Name the scenes");
    const auto addFolder = [&](const char* name, std::string& folder, const char* description) {
        app.add_option(name, folder, description)
            ->type_name("DIR")
            ->take_last();  // bullet_demos/run gives its own before
    };
    addFolder("--out", arguments.out, "Folder for what is written");
    addFolder("--scenes", arguments.scenes, "Folder of the scenes");
    addFolder("--meshes", arguments.meshes, "Folder that keeps generated meshes");
    addFilmOptions(app, arguments);
    app.add_flag("--progress-line", one_line, "Keep the progress on one line of a terminal");
    app.set_help_all_flag("--help-all", "Print this, and all keys and paths that --set takes");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        arguments.help = app.help();
        return arguments;
    } catch (const CLI::CallForAllHelp&) {
        arguments.help = app.help() + "\n" + describeChanges();
        return arguments;
    } catch (const CLI::ParseError& error) {
        return sherd::Error{std::string(error.what()) + " (see --help)"};
    }

    // What follows an assignment and is none.
    const auto last = std::find_if(assignments.begin(), assignments.end(), [](const std::string& word) {
        return word.find('=') == std::string::npos;
    });
    if (last != assignments.end() && named->count() == 0) {
        scene = *last;
        assignments.erase(last);
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
