#pragma once

#include "render/camera.h"
#include "world/placed_scene.h"

namespace demo {

/// What a click throws.
struct Throw {
    double speed_m_s = 15;
    double ball_diameter_m = 0;  ///< 0: chosen when a scene is loaded
};

/// The first thing in the world that a ray meets.
struct RayHit {
    btRigidBody* body = nullptr;  ///< none: nothing is met
    btVector3 point = btVector3(0, 0, 0);
    double distance_m = 0;
};
RayHit castRay(const btDiscreteDynamicsWorld& world, const render::Ray& ray);

/// Throws a steel ball from before the camera so that it comes down where the ray leads.
void throwBall(const btDiscreteDynamicsWorld& world, PlacedScene& scene, const render::Ray& ray,
               const Throw& how);

}  // namespace demo
