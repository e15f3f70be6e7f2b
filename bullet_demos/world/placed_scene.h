#pragma once

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

#include <memory>
#include <optional>
#include <vector>

#include "scenes/scene.h"
#include "world/scene_assets.h"

namespace demo {

/// A breakable body or a ball, where it is at one moment.
struct BodyState {
    std::optional<sherd::BreakableAsset> asset;  ///< none: a ball
    double ball_diameter_m = 0;
    Look look;
    Eigen::Isometry3d placed;  ///< from the asset's coordinates to the world
};

/// A ball that was put into the world.
struct PlacedBall {
    btRigidBody* body = nullptr;
    double diameter_m = 0;
};

/// A scene in a Bullet world that somebody else owns: its gravity, floor, breakable bodies and balls, and the
/// FractureWorld that breaks them. The destructor takes all of them out again; the world outlives it. How the
/// bodies break is the scene's to say (BreakableBody::settings), all else of the settings the assets'.
class PlacedScene {
  public:
    PlacedScene(btDiscreteDynamicsWorld& world, const Scene& scene, const SceneAssets& assets);
    ~PlacedScene();
    PlacedScene(const PlacedScene&) = delete;
    PlacedScene& operator=(const PlacedScene&) = delete;

    /// One more ball; it stays until the scene is taken out.
    btRigidBody* addBall(const Ball& ball);

    sherd::FractureWorld& fracture() { return *fracture_; }
    const sherd::FractureWorld& fracture() const { return *fracture_; }
    const std::vector<PlacedBall>& balls() const { return balls_; }
    /// How a breakable body of the scene, or a fragment of one, is to be drawn.
    const Look& lookOf(const btRigidBody& body) const;

    /// All that moves: breakable bodies first, then balls.
    std::vector<BodyState> states() const;

  private:
    struct PlainBody;

    void addFloor();
    void addBody(BreakableBody& body, const sherd::BreakableAsset& asset);
    btRigidBody* addPlain(std::unique_ptr<btCollisionShape> shape, double mass_kg, const Vec3& position,
                          const Touch& touch);

    btDiscreteDynamicsWorld& world_;
    Scene scene_;
    std::vector<std::unique_ptr<PlainBody>> plain_bodies_;
    std::vector<PlacedBall> balls_;
    std::unique_ptr<sherd::FractureWorld> fracture_;
};

}  // namespace demo
