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

TEST(Report, CountsDroppedDebrisAsDroppedNotAsLost) {
    const demo::Scene scene = crumblingTile();
    const auto assets = demo::makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
    ASSERT_TRUE(assets.ok()) << assets.error();
    demo::Progress progress(demo::Progress::Style::few_lines);
    const demo::SceneRun run = demo::runScene(scene, assets.value(), progress);
    const auto report = demo::makeReport(scene, assets.value(), run, {});
    EXPECT_GT(report["dropped_mass_kg"].get<double>(), 0);
    EXPECT_LT(report["mass_error_rel"].get<double>(), 1e-5) << "bodies of Bullet weigh in single precision";
    EXPECT_EQ(report["bodies"][0]["settings"]["fracture"]["debris"], "dropped");
    EXPECT_EQ(report["bodies"][0]["material"]["name"], "plaster");
    EXPECT_EQ(report["bodies"][0]["material"]["failure_criterion"], "largest_principal_stress");
    EXPECT_NE(demo::summarise(run, report).find("dropped"), std::string::npos);
}

}  // namespace
