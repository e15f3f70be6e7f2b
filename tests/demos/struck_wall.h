#pragma once

#include <gtest/gtest.h>

#include "headless/scene_run.h"

namespace demo {

/// A ball on its way to a coarse wall of plaster, which it breaks as soon as it has come that far.
inline Scene struckWall(double way_m = 0.25) {
    Scene scene;
    scene.name = "struck_wall";
    BreakableBody wall;
    wall.shape = Box{Vec3(1, 0.1, 1), 0.25};
    wall.material = sherd::Material::plaster();
    scene.bodies = {wall};
    Ball ball;
    ball.position = Vec3(0, -0.15 - way_m, 0.5);
    ball.velocity = Vec3(0, 8, 0);
    scene.balls = {ball};
    scene.duration_s = 0.2;
    return scene;
}

inline SceneRun runOf(const Scene& scene) {
    const auto assets = makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
    EXPECT_TRUE(assets.ok()) << assets.error();
    Progress progress(Progress::Style::few_lines);
    return runScene(scene, assets.value(), progress);
}

}  // namespace demo
