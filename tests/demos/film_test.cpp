// What a film shows, and when.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "film/frame_files.h"
#include "film/frame_times.h"
#include "film/recording.h"
#include "headless/pov_file.h"
#include "struck_wall.h"
#include "support/temporary_path.h"

namespace {

using namespace demo;
namespace fs = std::filesystem;

/// What is there at that time.
std::vector<BodyState> statesAt(const std::vector<Track>& tracks, double time_s) {
    std::vector<BodyState> states;
    for (const Track& track : tracks)
        if (track.isThereAt(time_s)) states.push_back(track.body);
    return states;
}

double volumeOf(const std::vector<BodyState>& states) {
    double volume = 0;
    for (const BodyState& state : states)
        if (state.asset) volume += state.asset->volume();
    return volume;
}

TEST(Recording, HasTheWholeBodyOrAllOfItsPiecesAtAnyTime) {
    const Scene scene = struckWall();
    const SceneRun run = runOf(scene);
    ASSERT_GT(run.first_break_s, 0);
    for (double time_s = 0; time_s <= scene.duration_s; time_s += 0.0017) {
        const std::vector<BodyState> states = statesAt(run.tracks, time_s);
        EXPECT_NEAR(volumeOf(states), 0.1, 1e-6) << time_s;
        EXPECT_EQ(std::count_if(states.begin(), states.end(), [](const auto& s) { return !s.asset; }), 1);
    }
    EXPECT_EQ(statesAt(run.tracks, 0).size(), 2u);
    EXPECT_EQ(statesAt(run.tracks, scene.duration_s).size(), run.after.size());
}

TEST(Recording, FragmentsAreBornWhereTheWholeBodyWas) {
    const Scene scene = struckWall();
    const SceneRun run = runOf(scene);
    const Track& wall = run.tracks.front();
    ASSERT_TRUE(wall.is_replaced);
    EXPECT_NEAR(wall.keys.back().time_s, run.first_break_s - scene.time_step_s, 1e-9);
    int pieces = 0;
    for (const Track& track : run.tracks) {
        if (track.born_s() != wall.keys.back().time_s) continue;
        ++pieces;
        EXPECT_EQ(track.keys.front().placed.matrix(), wall.keys.back().placed.matrix());
    }
    EXPECT_GT(pieces, 1);
}

TEST(Recording, MovesEvenlyBetweenTwoKeysAndRestsAfterTheLast) {
    Track track;
    Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
    turned.linear() = Eigen::AngleAxisd(1, Vec3::UnitZ()).toRotationMatrix();
    turned.translation() = Vec3(2, 0, 0);
    track.keys = {{1, Eigen::Isometry3d::Identity()}, {2, turned}};
    EXPECT_FALSE(track.isThereAt(0.5));
    EXPECT_LT((track.placedAt(1.25).translation() - Vec3(0.5, 0, 0)).norm(), 1e-12);
    EXPECT_NEAR(Eigen::AngleAxisd(track.placedAt(1.25).linear()).angle(), 0.25, 1e-12);
    EXPECT_EQ(track.placedAt(9).matrix(), turned.matrix());
    EXPECT_TRUE(track.isThereAt(9));
    track.is_replaced = true;
    EXPECT_TRUE(track.isThereAt(1.99));
    EXPECT_FALSE(track.isThereAt(2)) << "its fragments are there then";
}

TEST(FrameTimes, GoEvenlyWhereNothingIsSlow) {
    const std::vector<double> times = frameTimes({25, 8}, {}, 2);
    ASSERT_EQ(times.size(), 51u);
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], 0.04 * static_cast<double>(i), 1e-9);
}

TEST(FrameTimes, AreSlowFromBeforeTheBreakOn) {
    const std::vector<double> times = frameTimes({30, 10}, {1, 0.2}, 2);
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double step = times[i] - times[i - 1];
        const bool is_fast = times[i] < 0.85 || times[i - 1] > 1.4;
        const bool is_slow = times[i - 1] > 0.95 && times[i] < 1.2;
        EXPECT_NEAR(step, is_fast ? 1.0 / 30 : is_slow ? 1.0 / 300 : step, 1e-9) << times[i];
        EXPECT_GT(step, 1.0 / 300 - 1e-9);
    }
}

TEST(FrameFiles, AreOneAFrameAndNameTheBodiesThatAreThere) {
    const Scene scene = struckWall();
    const SceneRun run = runOf(scene);
    const fs::path folder = temporaryPath("frames");
    fs::create_directories(folder);
    std::ofstream(folder / "frame_9999.png") << "of an earlier film";
    ASSERT_TRUE(writeFrames(scene, run, {folder.string(), {30, 5}, 320}).ok());
    EXPECT_FALSE(fs::exists(folder / "frame_9999.png"));
    std::ifstream in(folder / "film.json");
    const nlohmann::json film = nlohmann::json::parse(in);
    EXPECT_EQ(film.at("scene"), "struck_wall");
    EXPECT_EQ(film.at("height"), 200);
    std::size_t frames = 0, bodies = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        frames += entry.path().extension() == ".pov";
        bodies += entry.path().extension() == ".inc";
    }
    EXPECT_EQ(frames, film.at("frames").get<std::size_t>());
    EXPECT_EQ(bodies, run.tracks.size());
    std::ifstream first(folder / "frame_0001.pov");
    const std::string text((std::istreambuf_iterator<char>(first)), {});
    EXPECT_NE(text.find("body_0000.inc"), std::string::npos);
    EXPECT_EQ(text.find("body_0002.inc"), std::string::npos) << "no fragment yet";
    fs::remove_all(folder);
}

TEST(PovFile, LightGoesThroughGlassAlone) {
    Scene scene = struckWall(5);
    scene.duration_s = 0.02;
    const auto hasGlass = [](const Scene& one) {
        const SceneRun run = runOf(one);
        std::ostringstream stage, body;
        writePovStage(stage, run.before, one.camera, PovStyle::still);
        writePovBody(body, run.before.front());
        const bool has_glass = stage.str().find("#declare Clear") != std::string::npos;
        for (const char* words : {"Clear_Face()", "inside_vector", "Clear_Inside("})
            EXPECT_EQ(body.str().find(words) != std::string::npos, has_glass) << words;
        return has_glass;
    };
    EXPECT_FALSE(hasGlass(scene));
    scene.bodies[0].material = sherd::Material::glass();
    EXPECT_TRUE(hasGlass(scene));
}

TEST(FrameFiles, SayWhatFolderCannotBeMade) {
    const auto written = writeFrames(struckWall(), {}, {"/proc/nowhere/frames", {}, 320});
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().find("/proc/nowhere/frames"), std::string::npos) << written.error();
}

}  // namespace
