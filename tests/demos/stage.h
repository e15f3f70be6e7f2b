#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
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

inline SceneAssets assetsOf(const Scene& scene) {
    auto made = makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
    EXPECT_TRUE(made.ok()) << made.error();
    return made.value();
}

/// A scene with its assets, stepped by hand.
struct Stage {
    explicit Stage(const Scene& given) : Stage(given, assetsOf(given)) {}
    Stage(const Scene& given, SceneAssets its)
        : scene(given), assets(std::move(its)), world(std::make_unique<SceneWorld>(scene, assets)) {}
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

/// One scene with many seeds: what its assets need for a blow is made once, at the first blow of all. The
/// scene's own seed and that of a stage together are where the strength scatters.
class SeededScene {
  public:
    explicit SeededScene(const Scene& scene) : scene_(scene), assets_(assetsOf(scene)) {}

    /// The strength scatters otherwise with another seed, and cracks run elsewhere.
    Stage stage(std::uint64_t seed) const {
        Scene scene = scene_;
        for (BreakableBody& body : scene.bodies)
            body.settings.strength.seed = body.settings.fracture.seed = seed;
        SceneAssets assets = assets_;
        for (sherd::BreakableAsset& body : assets.bodies) body = body.ofBody(seed);
        return Stage(scene, std::move(assets));
    }

  private:
    Scene scene_;
    SceneAssets assets_;
};

}  // namespace demo_tests
