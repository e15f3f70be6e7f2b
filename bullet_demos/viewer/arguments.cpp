#include "viewer/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "scenes/scenes.h"

namespace demo {
namespace {

/// What CLI11 fills in before it is looked at.
struct Raw {
    std::string scene = "coffee_cup", scenes = "bullet_demos/scenes", material, up, quality, show;
    std::vector<std::string> throws_at;
    std::vector<int> at_steps;
};

void addMeshOptions(CLI::App& app, Raw& raw, ViewArguments& arguments) {
    OwnMesh& mesh = arguments.state.choices.own_mesh;
    app.add_option("--material", raw.material, "Of the bodies")
        ->check(CLI::IsMember(materialNames()))
        ->type_name("NAME");
    app.add_option("--quality", raw.quality, "Of the sampling")
        ->check(CLI::IsMember(sherd::namesInFiles<sherd::Quality>()))
        ->type_name("NAME");
    app.add_flag("--repair", mesh.repair, "Mend the mesh, and wrap it where that is not enough");
    app.add_option("--shell", mesh.shell_thickness_m,
                   "Make the mesh hollow, with walls of this thickness, m: for vases and figures")
        ->check(CLI::PositiveNumber);
    app.add_option("--scale", mesh.scale, "Multiplies the coordinates of the mesh")
        ->check(CLI::PositiveNumber);
    app.add_option("--size", mesh.size_m, "Longest side of the mesh, m")->check(CLI::PositiveNumber);
    app.add_option("--up", raw.up, "Axis of the mesh that points up; left out, what is usual in its format")
        ->check(CLI::IsMember(sherd::namesInFiles<sherd::UpAxis>()))
        ->type_name("AXIS");
    app.add_option("--drop", mesh.drop_height_m, "Height that the mesh falls from, m")
        ->check(CLI::NonNegativeNumber);
}

void addScriptOptions(CLI::App& app, Raw& raw, ViewArguments& arguments) {
    Script& script = arguments.script;
    app.add_option("--steps", script.steps, "Do so many steps without hands, then end")
        ->check(CLI::PositiveNumber);
    app.add_option("--throw-at", raw.throws_at,
                   "Throw a ball at a place of the picture, from 0,0 at its upper left to 1,1, or at `body`")
        ->type_name("X,Y");
    app.add_option("--at-step", raw.at_steps, "Step of each throw")->type_name("N");
    app.add_option("--screenshot", script.screenshot, "Write the last picture there")->type_name("FILE");
    app.add_option("--frames", script.frames, "Write pictures into this folder")->type_name("DIR");
    app.add_option("--steps-per-frame", script.steps_per_frame,
                   "Steps from one of these pictures to the next")
        ->check(CLI::PositiveNumber);
    app.add_flag("--panels", script.panels, "Panels are in the pictures");
    app.add_option("--show", raw.show, "Draw over it: plain, stress, damage or pieces of particles")
        ->check(CLI::IsMember({"plain", "stress", "damage", "pieces"}))
        ->type_name("WHAT");
    app.add_flag("--contacts", arguments.state.overlays.contacts, "Draw contacts");
    app.add_flag("--shapes", arguments.state.overlays.collision_shapes, "Draw collision shapes");
    app.add_flag("--colours", arguments.state.overlays.coloured_pieces,
                 "Draw each piece in a colour of its own");
}

void addViewOptions(CLI::App& app, ViewArguments& arguments) {
    app.add_option("--ball-speed", arguments.state.throwing.speed_m_s, "Of balls that are thrown, m/s")
        ->check(CLI::PositiveNumber);
    app.add_option("--ball-size", arguments.state.throwing.ball_diameter_m, "Their diameter, m")
        ->check(CLI::PositiveNumber);
    app.add_option("--width", arguments.size.width, "Of the picture, pixels")->check(CLI::Range(64, 8192));
    app.add_option("--height", arguments.size.height, "Of the picture, pixels")->check(CLI::Range(64, 8192));
    app.add_option("--samples", arguments.samples,
                   "Of a pixel, which smooth the edges; 4, or in a window without a graphics card none")
        ->check(CLI::Range(0, 16));
    app.add_option("--distance", arguments.zoom, "Multiplies the camera's distance")
        ->check(CLI::PositiveNumber);
    app.add_flag("--off-screen", arguments.off_screen, "Open no window; needs --steps");
    app.add_flag("!--no-prepare", arguments.prepare, "Start at once; the first blows then take longer");
    app.add_option("--pictures", arguments.pictures, "Folder of pictures that keys ask for")
        ->type_name("DIR");
    app.add_option("--meshes", arguments.meshes, "Folder that keeps generated meshes")->type_name("DIR");
}

sherd::Status readThrows(const Raw& raw, Script& script) {
    for (std::size_t i = 0; i < raw.throws_at.size(); ++i) {
        PlannedThrow planned;
        if (i < raw.at_steps.size()) planned.step = raw.at_steps[i];
        const std::string& at = raw.throws_at[i];
        planned.at_body = at == "body";
        char rest = 0;
        if (!planned.at_body &&
            std::sscanf(at.c_str(), "%f,%f%c", &planned.at.x(), &planned.at.y(), &rest) != 2)
            return sherd::Error{
                "--throw-at takes two numbers from 0 to 1, as 0.5,0.4, or the word body; not '" + at + "'."};
        script.throws.push_back(planned);
    }
    if (raw.at_steps.size() > raw.throws_at.size())
        return sherd::Error{"There are more steps (--at-step) than throws (--throw-at)."};
    return sherd::success();
}

/// The file of a scene that is called by its name, or what was given.
sherd::Result<std::string> fileOf(const std::string& given, const std::string& scenes) {
    if (!std::filesystem::path(given).has_extension()) return sceneFile(given, scenes);
    if (std::filesystem::is_directory(given) || !std::filesystem::exists(given))
        return sherd::Error{"There is no file " + given + "; give the path of a mesh or of a scene (.json)."};
    return given;
}

sherd::Result<ViewArguments> understand(const Raw& raw, ViewArguments arguments) {
    Choices& choices = arguments.state.choices;
    auto file = fileOf(raw.scene, raw.scenes);
    if (!file) return sherd::Error{file.error()};
    choices.file = std::move(file).value();
    arguments.scene_files = sceneFiles(raw.scenes);
    if (!raw.material.empty()) choices.material = raw.material;
    choices.quality = sherd::valueNamed<sherd::Quality>(raw.quality);
    choices.own_mesh.up_axis = sherd::valueNamed<sherd::UpAxis>(raw.up);
    arguments.state.budget.limited = arguments.script.steps == 0;  // somebody waits for the next frame
    static const std::map<std::string, ParticleColour> colours = {{"plain", ParticleColour::plain},
                                                                  {"stress", ParticleColour::stress},
                                                                  {"damage", ParticleColour::damage},
                                                                  {"pieces", ParticleColour::pieces}};
    if (!raw.show.empty()) arguments.state.overlays.particles = colours.at(raw.show);
    const sherd::Status thrown = readThrows(raw, arguments.script);
    if (!thrown) return sherd::Error{thrown.error()};
    if (arguments.script.steps == 0 && (arguments.off_screen || !arguments.script.screenshot.empty() ||
                                        !arguments.script.frames.empty() || !raw.throws_at.empty()))
        return sherd::Error{"Without hands it takes a number of steps: add --steps N."};
    return arguments;
}

}  // namespace

sherd::Result<ViewArguments> parseViewArguments(int argc, const char* const* argv) {
    ViewArguments arguments;
    Raw raw;
    CLI::App app("Shows a scene in a window: throw balls with a click, hold bodies with the right button.");
    app.name("bullet_demos/run --view");
    app.add_option("SCENE", raw.scene,
                   "Name of a scene, a scene file (.json), or a mesh (OBJ, STL, PLY, OFF, glTF)")
        ->capture_default_str();
    app.add_option("--scenes", raw.scenes, "Folder of the scenes")->type_name("DIR");
    app.add_option("--preset", arguments.state.choices.preset,
                   "Figures that the scene file has under this name")
        ->type_name("NAME");
    app.add_option(
           "--set", arguments.state.choices.changes,
           "Change figures of the scene, as bullet_demos/run does; its --help-all lists them. Of a mesh: "
           "settings by their paths, as fracture.largest_fragment_count=36")
        ->type_name("KEY=VALUE");
    addMeshOptions(app, raw, arguments);
    addViewOptions(app, arguments);
    addScriptOptions(app, raw, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        arguments.help = app.help();
        return arguments;
    } catch (const CLI::ParseError& error) {
        return sherd::Error{std::string(error.what()) + " (see --help)"};
    }
    return understand(raw, std::move(arguments));
}

}  // namespace demo
