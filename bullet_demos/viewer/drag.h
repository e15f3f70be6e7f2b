#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

#include "render/camera.h"
#include "viewer/throws.h"

namespace demo {

/// A body held at a point by the mouse, through the joint that Bullet's own examples use.
class Drag {
  public:
    explicit Drag(btDiscreteDynamicsWorld& world) : world_(world) {}
    ~Drag() { letGo(); }
    Drag(const Drag&) = delete;
    Drag& operator=(const Drag&) = delete;

    /// Takes what the ray meets; false if that is nothing, or does not move.
    bool take(const render::Ray& ray);
    void moveTo(const render::Ray& ray);
    void letGo();
    bool holding() const { return joint_ != nullptr; }
    /// A body that breaks is let go by the world; the joint is then ours to forget.
    void forget(const btTypedConstraint* removed);

  private:
    btDiscreteDynamicsWorld& world_;
    std::unique_ptr<btPoint2PointConstraint> joint_;
    btRigidBody* body_ = nullptr;
    double distance_m_ = 0;  ///< from the eye
};

}  // namespace demo
