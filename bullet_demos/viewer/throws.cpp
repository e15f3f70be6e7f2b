#include "viewer/throws.h"

#include <algorithm>

#include "viewer/conversions.h"

namespace demo {

RayHit castRay(const btDiscreteDynamicsWorld& world, const render::Ray& ray) {
    constexpr float reach_m = 100;
    const btVector3 from = toBullet(ray.origin), to = from + reach_m * toBullet(ray.direction);
    btCollisionWorld::ClosestRayResultCallback closest(from, to);
    world.rayTest(from, to, closest);
    if (!closest.hasHit()) return {};
    auto* body = const_cast<btRigidBody*>(btRigidBody::upcast(closest.m_collisionObject));
    return {body, closest.m_hitPointWorld, closest.m_closestHitFraction * reach_m};
}

void throwBall(const btDiscreteDynamicsWorld& world, PlacedScene& scene, const render::Ray& ray,
               const Throw& how) {
    // A ball that flies far would let the one who clicked wait, and fall out of the aim.
    constexpr double longest_flight_m = 1.5, flight_into_nothing_m = 3;
    const RayHit hit = castRay(world, ray);
    const Vec3 along = ray.direction.cast<double>();
    const double distance = hit.body ? hit.distance_m : flight_into_nothing_m;
    const Vec3 aim = ray.origin.cast<double>() + distance * along;
    const double flight = std::clamp(distance - how.ball_diameter_m, how.ball_diameter_m, longest_flight_m);
    Ball ball;
    ball.diameter_m = how.ball_diameter_m;
    ball.position = aim - flight * along;
    ball.position.z() = std::max(ball.position.z(), how.ball_diameter_m);
    const btVector3 pull = world.getGravity();
    const Vec3 gravity(pull.x(), pull.y(), pull.z());
    const double seconds = (aim - ball.position).norm() / how.speed_m_s;
    ball.velocity = (aim - ball.position) / seconds - gravity * seconds / 2;
    scene.addBall(ball);
}

}  // namespace demo
