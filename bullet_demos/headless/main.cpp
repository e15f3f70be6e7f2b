#include <exception>
#include <iostream>

#include "film/frame_files.h"
#include "film/gltf_file.h"
#include "headless/arguments.h"
#include "headless/output_files.h"
#include "headless/report.h"
#include "headless/scene_run.h"
#include "headless/summary.h"
#include "scenes/scene_file.h"
#include "scenes/scenes.h"

namespace {

constexpr int further_blows = 3;  ///< of which the middle time counts

/// Scene in, files out.
sherd::Status runDemo(const demo::Arguments& arguments) {
    const demo::Scene& scene = arguments.scene;
    demo::Progress progress(arguments.progress);
    const auto announce = [&progress](const std::string& what) { progress.show(0, what); };
    const auto assets = demo::makeAssets(scene, arguments.meshes, announce);
    if (!assets) return sherd::Error{assets.error()};

    const demo::SceneRun run = demo::runScene(scene, assets.value(), progress);
    demo::FurtherBlows further;
    for (int i = 0; i < further_blows; ++i) {
        if (const auto blow = demo::strikeAgain(scene, assets.value())) further.push_back(*blow);
    }

    const auto report = demo::makeReport(scene, assets.value(), run, further);
    const std::string folder = arguments.out + "/" + scene.name;
    sherd::Status written = demo::writeOutputs(scene, run, report, folder);
    if (written && !arguments.film.folder.empty()) written = demo::writeFrames(scene, run, arguments.film);
    if (written && !arguments.gltf.empty()) written = demo::writeGltf(run.tracks, arguments.gltf);
    if (!written) return written;
    std::cout << demo::summarise(run, report) << "written to " << folder << std::endl;
    return sherd::success();
}

sherd::Status listScenes(const std::string& folder) {
    for (const std::string& file : demo::sceneFiles(folder)) {
        const auto scene = demo::readScene(file);
        if (!scene) return sherd::Error{scene.error()};
        std::cout << scene.value().name << ": " << scene.value().summary << "\n";
    }
    return sherd::success();
}

int demoMain(int argc, const char* const* argv) {
    const auto arguments = demo::parseArguments(argc, argv);
    if (!arguments) {
        std::cerr << arguments.error() << "\n";
        return 2;
    }
    if (!arguments.value().help.empty()) {
        std::cout << arguments.value().help;
        return 0;
    }
    if (arguments.value().show_list) {
        const sherd::Status listed = listScenes(arguments.value().scenes);
        if (!listed) std::cerr << listed.error() << "\n";
        return listed ? 0 : 1;
    }
    const sherd::Status done = runDemo(arguments.value());
    if (!done) std::cerr << done.error() << "\n";
    return done ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return demoMain(argc, argv);
    } catch (const std::exception& failure) {
        std::cerr << "The demo stopped: " << failure.what() << "\n";
        return 1;
    }
}
