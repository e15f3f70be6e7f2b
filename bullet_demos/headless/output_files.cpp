#include "headless/output_files.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "headless/pov_file.h"

namespace demo {
namespace {

namespace fs = std::filesystem;
using sherd::Error;
using sherd::Status;

Status clearFolder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
        const std::string extension = at->path().extension().string();
        if (extension == ".obj" || extension == ".pov" || extension == ".png" || extension == ".json" ||
            extension == ".seconds") {
            fs::remove(at->path(), failure);
        }
    }
    if (failure)
        return Error{"Cannot prepare the folder " + folder.string() + ": " + failure.message() + "."};
    return sherd::success();
}

Status writeFragments(const std::vector<BodyState>& states, const fs::path& folder) {
    int number = 0;
    for (const BodyState& state : states) {
        if (!state.asset) continue;
        char name[32];
        std::snprintf(name, sizeof name, "fragment_%03d.obj", number++);
        const Status written = sherd::writeObj(state.asset->surface(), (folder / name).string());
        if (!written) return written;
    }
    return sherd::success();
}

Status writeReport(const nlohmann::ordered_json& report, const fs::path& path) {
    std::ofstream out(path);
    out << report.dump(2) << "\n";
    out.flush();
    if (!out) return Error{"Cannot write " + path.string() + "; is the disk full or the folder read-only?"};
    return sherd::success();
}

}  // namespace

Status writeOutputs(const Scene& scene, const SceneRun& run, const nlohmann::ordered_json& report,
                    const std::string& folder) {
    const fs::path place(folder);
    Status status = clearFolder(place);
    if (status) status = writeReport(report, place / "report.json");
    if (status) status = writeFragments(run.after, place);
    if (status) status = writePov(run.before, scene.camera, (place / "before.pov").string());
    if (status && !run.impact.empty())
        status = writePov(run.impact, scene.camera, (place / "impact.pov").string());
    if (status) status = writePov(run.shown, scene.camera, (place / "after.pov").string());
    return status;
}

}  // namespace demo
