#pragma once

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace demo {

/// The assets of a scene's breakable bodies, checked and sampled; they outlive runs, so that a second run
/// finds them factored.
struct SceneAssets {
    std::vector<sherd::BreakableAsset> bodies;
    double sample_ms = 0;  ///< wall-clock time of sampling them
};

/// Generated meshes are kept in the folder `meshes`; what takes long is said to `announce`.
sherd::Result<SceneAssets> makeAssets(const Scene& scene, const std::string& meshes,
                                      const std::function<void(const std::string&)>& announce);

/// A breakable body or a ball, where it is at one moment.
struct BodyState {
    std::optional<sherd::BreakableAsset> asset;  ///< none: a ball
    double ball_diameter_m = 0;
    Look look;
    Eigen::Isometry3d placed;  ///< from the asset's coordinates to the world
};

/// A scene set up in a Bullet world of its own.
class SceneWorld {
  public:
    SceneWorld(const Scene& scene, const SceneAssets& assets);
    ~SceneWorld();
    SceneWorld(const SceneWorld&) = delete;
    SceneWorld& operator=(const SceneWorld&) = delete;

    void step();
    sherd::FractureWorld& fracture() { return *fracture_; }

    /// All that moves: breakable bodies first, then balls.
    std::vector<BodyState> states() const;

  private:
    void addFloor();
    void addBody(BreakableBody& body, const sherd::BreakableAsset& asset);
    void addBall(const Ball& ball);
    btRigidBody* addPlain(std::unique_ptr<btCollisionShape> shape, double mass_kg, const Vec3& position,
                          const Touch& touch);

    Scene scene_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> plain_bodies_;
    std::vector<btRigidBody*> balls_;
    std::unique_ptr<sherd::FractureWorld> fracture_;
};

}  // namespace demo
