#include "headless/report.h"

#include <gtest/gtest.h>

#include "headless/progress.h"
#include "headless/scene_run.h"
#include "headless/summary.h"

namespace {

using demo::Vec3;

/// A plaster tile that falls flat and whose every small piece is dropped.
demo::Scene crumblingTile() {
    demo::BreakableBody tile;
    tile.shape = demo::Box{Vec3(0.3, 0.3, 0.03), 0.1};
    tile.material = sherd::Material::plaster();
    tile.turn_deg = Vec3(20, 10, 0);
    tile.position = Vec3(0, 0, 1);
    tile.settings.fracture.fragment_count = 20;
    tile.settings.fracture.smallest_fragment_m3 = 1e-4;
    tile.settings.fracture.debris = sherd::Debris::dropped;
    demo::Scene scene;
    scene.bodies = {tile};
    scene.duration_s = 0.6;
    return scene;
}

class Report : public testing::Test {
  protected:
    void SetUp() override {
        const demo::Scene scene = crumblingTile();
        const auto assets = demo::makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
        ASSERT_TRUE(assets.ok()) << assets.error();
        demo::Progress progress(demo::Progress::Style::few_lines);
        run = demo::runScene(scene, assets.value(), progress);
        report = demo::makeReport(scene, assets.value(), run, {});
    }

    demo::SceneRun run;
    nlohmann::ordered_json report;
};

TEST_F(Report, CountsDroppedDebrisAsDroppedNotAsLost) {
    EXPECT_GT(report["dropped_mass_kg"].get<double>(), 0);
    EXPECT_LT(report["mass_error_rel"].get<double>(), 1e-5) << "bodies of Bullet weigh in single precision";
    EXPECT_EQ(report["bodies"][0]["settings"]["fracture"]["debris"], "dropped");
    EXPECT_EQ(report["bodies"][0]["material"]["name"], "plaster");
    EXPECT_EQ(report["bodies"][0]["material"]["failure_criterion"], "largest_principal_stress");
    EXPECT_NE(demo::summarise(run, report).find("dropped"), std::string::npos);
}

TEST_F(Report, SaysWhatDecidedTheBlows) {
    EXPECT_GT(report["blows_by_full"].get<int>(), 0);
    EXPECT_EQ(report["blows_by_gate"].get<int>() + report["blows_by_coarse"].get<int>() +
                  report["blows_by_reduced"].get<int>() + report["blows_by_full"].get<int>(),
              report["blows_seen"].get<int>());
    for (const auto& event : report["events"]) EXPECT_EQ(event["level"], "full");
    EXPECT_FALSE(report["events"][0].contains("full_solve_outcome"));

    demo::SceneRun checked = run;
    checked.events[0].event.level = sherd::Level::gate;
    checked.events[0].event.full_solve_outcome = sherd::Outcome::broke;
    checked.events[0].event.full_solve_largest_stress_pa = 5;
    const auto event = demo::makeReport(crumblingTile(), {}, checked, {})["events"][0];
    EXPECT_EQ(event["level"], "gate");
    EXPECT_EQ(event["full_solve_outcome"], "broke");
    EXPECT_EQ(event["full_solve_largest_stress_pa"], 5);
}

TEST_F(Report, ListsEveryStageAndTheirSum) {
    const auto& ms = report["ms"];
    double sum_ms = 0;
    for (const char* stage :
         {"gate",     "sample",   "assemble",  "factor", "loads",    "solve",   "stress", "damage",
          "cluster",  "surface",  "fragments", "bodies", "swap",     "check",   "sync",   "release",
          "snapshot", "overlaps", "ground",    "sweep",  "contacts", "restore", "resolve"})
        sum_ms += ms[stage].get<double>();
    EXPECT_NEAR(ms["stages_ms"].get<double>(), sum_ms, 1e-9 * sum_ms);
    EXPECT_LE(ms["stages_ms"].get<double>(), ms["ours_ms"].get<double>());
    EXPECT_LE(ms["ours_ms"].get<double>() + ms["bullet_solve_ms"].get<double>(),
              ms["steps_ms"].get<double>());
}

}  // namespace
