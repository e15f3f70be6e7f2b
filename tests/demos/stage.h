#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "scenes/scene_file.h"
#include "world/scene_world.h"

namespace demo_tests {

using namespace demo;

/// A scene of the tree; where it makes its mesh, a coarse one.
inline Scene named(const std::string& name) {
    std::vector<std::string> changes;
    if (name == "coffee_plate" || name == "plane") changes.push_back("triangles=8000");
    auto read = readScene(SHERD_SCENES "/" + name + ".json", "", changes);
    EXPECT_TRUE(read) << read.error();
    return read.value();
}

/// A scene with its assets, stepped by hand.
struct Stage {
    explicit Stage(const Scene& given) : scene(given) {
        auto made = makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
        EXPECT_TRUE(made.ok()) << made.error();
        assets = made.value();
        world = std::make_unique<SceneWorld>(scene, assets);
    }
    void run(double seconds) {
        for (int i = 0; i < std::lround(seconds / scene.time_step_s); ++i) {
            world->step();
            for (const auto& event : world->fracture().takeEvents()) events.push_back(event);
        }
        this->seconds += seconds;
    }
    /// Steps until the first break; false if there is none within `seconds`.
    bool runToBreak(double most_seconds) {
        while (seconds < most_seconds && bodies() <= scene.bodies.size()) {
            before_step = world->states().front().placed;
            run(scene.time_step_s);
        }
        return bodies() > scene.bodies.size();
    }
    std::size_t bodies() const { return world->fracture().bodies().size(); }

    Scene scene;
    SceneAssets assets;
    std::unique_ptr<SceneWorld> world;
    std::vector<sherd::BlowEvent> events;
    double seconds = 0;             ///< simulated so far
    Eigen::Isometry3d before_step;  ///< where the first body was before the last step of runToBreak
};

}  // namespace demo_tests
