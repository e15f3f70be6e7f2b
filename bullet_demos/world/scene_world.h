#pragma once

#include <btBulletDynamicsCommon.h>

#include <vector>

#include "world/placed_scene.h"

namespace demo {

/// A scene set up in a Bullet world of its own.
class SceneWorld {
  public:
    SceneWorld(const Scene& scene, const SceneAssets& assets);

    void step();
    btDiscreteDynamicsWorld& world() { return world_; }
    PlacedScene& placed() { return placed_; }
    sherd::FractureWorld& fracture() { return placed_.fracture(); }
    std::vector<BodyState> states() const { return placed_.states(); }

  private:
    double time_step_s_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    PlacedScene placed_;
};

}  // namespace demo
