#include "world/scene_world.h"

namespace demo {

SceneWorld::SceneWorld(const Scene& scene, const SceneAssets& assets)
    : time_step_s_(scene.time_step_s), placed_(world_, scene, assets) {}

void SceneWorld::step() {
    const auto dt = btScalar(time_step_s_);
    world_.stepSimulation(dt, 1, dt);
}

}  // namespace demo
