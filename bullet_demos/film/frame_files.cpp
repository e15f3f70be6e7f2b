#include "film/frame_files.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "headless/pov_file.h"

namespace demo {
namespace {

namespace fs = std::filesystem;
using sherd::Error;
using sherd::Status;

constexpr double slow_part_s = 0.1;  ///< where the scene does not say when its last picture is taken

std::string numbered(const char* format, std::size_t number) {
    char name[32];
    std::snprintf(name, sizeof name, format, static_cast<int>(number));
    return name;
}

bool isOfAFilm(const fs::path& file) {
    const std::string name = file.filename().string(), extension = file.extension().string();
    return (name.rfind("frame_", 0) == 0 && (extension == ".pov" || extension == ".png")) ||
           (name.rfind("body_", 0) == 0 && extension == ".inc");
}

Status clearFrames(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure))
        if (isOfAFilm(at->path())) fs::remove(at->path(), failure);
    if (failure)
        return Error{"Cannot prepare the folder " + folder.string() + ": " + failure.message() + "."};
    return sherd::success();
}

template <class Write>
Status writeFile(const fs::path& path, Write write) {
    std::ofstream out(path);
    out.precision(9);
    write(out);
    out.flush();
    if (!out) return Error{"Cannot write " + path.string() + "; is the disk full or the folder read-only?"};
    return sherd::success();
}

/// POV-Ray multiplies a row with a matrix of four rows and three columns.
void writePlace(std::ostream& out, const Eigen::Isometry3d& placed) {
    out << "matrix <";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) out << (column + row ? "," : "") << placed.matrix()(row, column);
    out << ">";
}

void writeFrame(std::ostream& out, const std::vector<Track>& tracks, double time_s) {
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        if (!tracks[i].isThereAt(time_s)) continue;
        out << "object { #include \"" << numbered("body_%04d.inc", i) << "\" ";
        writePlace(out, tracks[i].placedAt(time_s));
        out << " }\n";
    }
}

std::vector<BodyState> statesToFit(const SceneRun& run) {
    std::vector<BodyState> states = run.before;
    if (run.first_break_s >= 0) states.insert(states.end(), run.shown.begin(), run.shown.end());
    return states;
}

Status writeBodies(const std::vector<Track>& tracks, const fs::path& folder) {
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        BodyState body = tracks[i].body;
        body.placed.setIdentity();
        const Status written = writeFile(folder / numbered("body_%04d.inc", i),
                                         [&](std::ostream& out) { writePovBody(out, body); });
        if (!written) return written;
    }
    return sherd::success();
}

}  // namespace

Status writeFrames(const Scene& scene, const SceneRun& run, const Film& film) {
    const fs::path folder(film.folder);
    Status status = clearFrames(folder);
    if (status) status = writeBodies(run.tracks, folder);
    if (!status) return status;
    const SlowPart slow{run.first_break_s < 0 ? -1 : run.first_break_s - scene.time_step_s,
                        scene.after_picture_s > 0 ? scene.after_picture_s : slow_part_s};
    const std::vector<double> times = frameTimes(film.pace, slow, scene.duration_s);
    std::ostringstream stage;
    stage.precision(9);
    writePovStage(stage, statesToFit(run), scene.camera, PovStyle::film);
    for (std::size_t i = 0; status && i < times.size(); ++i) {
        status = writeFile(folder / numbered("frame_%04d.pov", i + 1), [&](std::ostream& out) {
            out << stage.str();
            writeFrame(out, run.tracks, times[i]);
        });
    }
    if (!status) return status;
    const nlohmann::ordered_json summary = {
        {"scene", scene.name}, {"frames", times.size()},         {"fps", film.pace.frames_per_second},
        {"width", film.width}, {"height", film.width * 10 / 16}, {"times_s", times}};
    return writeFile(folder / "film.json", [&](std::ostream& out) { out << summary.dump(1) << '\n'; });
}

}  // namespace demo
