#pragma once

#include <btBulletDynamicsCommon.h>

#include <deque>
#include <memory>
#include <vector>

#include "prototype/level.h"
#include "render/camera.h"

namespace prototype {

/// The Bullet world with all that never breaks: floor, blocks, balls.
class Hall {
  public:
    static constexpr float ball_radius = 0.06f;

    explicit Hall(const Level& level);
    ~Hall();
    Hall(const Hall&) = delete;
    Hall& operator=(const Hall&) = delete;

    /// What the ray meets, or a place in the air.
    btVector3 aimOf(const render::Ray& ray) const;
    /// Throws a ball from below the ray's origin so that it comes down where the ray leads.
    void throwBall(const render::Ray& ray);
    /// Takes a ball out of the world; other bodies are left alone.
    void removeBall(const btRigidBody* body);
    /// Takes out those that have left the hall, and the oldest where there are too many.
    void removeOldBalls();

    btDiscreteDynamicsWorld& world() { return world_; }
    std::vector<btTransform> balls() const;  ///< where they are to be drawn

  private:
    struct Rigid;
    void addBox(const btVector3& centre, const btVector3& size);

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btSphereShape ball_shape_{ball_radius};
    std::vector<std::unique_ptr<Rigid>> blocks_;
    std::deque<std::unique_ptr<Rigid>> balls_;
};

}  // namespace prototype
