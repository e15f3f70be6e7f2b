#include "world/placed_scene.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace demo {
namespace {

constexpr double pi = 3.14159265358979323846;

btVector3 toBullet(const Vec3& v) {
    return btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z()));
}

Eigen::Isometry3d toEigen(const btTransform& transform) {
    const btQuaternion q = transform.getRotation();
    const btVector3 origin = transform.getOrigin();
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
    placed.linear() = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
    placed.translation() = Vec3(origin.x(), origin.y(), origin.z());
    return placed;
}

Eigen::Matrix3d rotation(const Vec3& turn_deg) {
    const Vec3 angle = turn_deg * pi / 180;
    return (Eigen::AngleAxisd(angle.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angle.y(), Vec3::UnitY()) *
            Eigen::AngleAxisd(angle.x(), Vec3::UnitX()))
        .toRotationMatrix();
}

/// Turned as the scene says, with the lowest vertex at the height that it asks for.
btTransform startOf(const BreakableBody& body, const sherd::BreakableAsset& asset) {
    const Eigen::Matrix3d turn = rotation(body.turn_deg);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : asset.surface().vertices) lowest = std::min(lowest, (turn * vertex).z());
    const Eigen::Quaterniond q(turn);
    return btTransform(btQuaternion(btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())),
                       toBullet(body.position - Vec3(0, 0, lowest)));
}

void setTouch(btRigidBody& body, const Touch& touch) {
    body.setFriction(btScalar(touch.friction));
    body.setRestitution(btScalar(touch.restitution));
}

btTransform at(const Vec3& position) {
    return btTransform(btQuaternion::getIdentity(), toBullet(position));
}

}  // namespace

/// The floor or a ball, with all that Bullet leaves to its owner.
struct PlacedScene::PlainBody {
    PlainBody(std::unique_ptr<btCollisionShape> its_shape, double mass_kg, const btVector3& inertia,
              const Vec3& position)
        : shape(std::move(its_shape)),
          motion(at(position)),
          body(btRigidBody::btRigidBodyConstructionInfo(btScalar(mass_kg), &motion, shape.get(), inertia)) {}

    std::unique_ptr<btCollisionShape> shape;
    btDefaultMotionState motion;
    btRigidBody body;
};

PlacedScene::PlacedScene(btDiscreteDynamicsWorld& world, const Scene& scene, const SceneAssets& assets)
    : world_(world), scene_(scene) {
    world_.setGravity(toBullet(scene.gravity));
    fracture_ = std::make_unique<sherd::FractureWorld>(&world_);
    // Nobody waits for the next frame: every blow is decided in its step.
    if (!fracture_->setBudget(sherd::Budget::none())) std::abort();
    addFloor();
    for (std::size_t i = 0; i < assets.bodies.size(); ++i) addBody(scene_.bodies[i], assets.bodies[i]);
    for (const Ball& ball : scene_.balls) addBall(ball);
}

PlacedScene::~PlacedScene() {
    fracture_.reset();
    for (const auto& plain : plain_bodies_) world_.removeRigidBody(&plain->body);
}

const Look& PlacedScene::lookOf(const btRigidBody& body) const {
    // Fragments inherit the user pointer of the body that they come from.
    return static_cast<const BreakableBody*>(body.getUserPointer())->look;
}

std::vector<BodyState> PlacedScene::states() const {
    std::vector<BodyState> states;
    for (const btRigidBody* body : fracture_->bodies()) {
        states.push_back(
            {*fracture_->asset(body), 0, lookOf(*body), toEigen(fracture_->assetTransform(body))});
    }
    for (const PlacedBall& ball : balls_)
        states.push_back({std::nullopt, ball.diameter_m, {}, toEigen(ball.body->getWorldTransform())});
    return states;
}

void PlacedScene::addFloor() {
    constexpr double half_width_m = 20, half_depth_m = 0.5;
    auto slab = std::make_unique<btBoxShape>(toBullet(Vec3(half_width_m, half_width_m, half_depth_m)));
    addPlain(std::move(slab), 0, Vec3(0, 0, -half_depth_m), scene_.floor);
}

void PlacedScene::addBody(BreakableBody& body, const sherd::BreakableAsset& asset) {
    sherd::BodyOptions options(startOf(body, asset));
    options.velocity = toBullet(body.velocity);
    options.angular_velocity = toBullet(body.spin);
    options.user_pointer = &body;
    options.fracture = body.settings.fracture;
    // makeAssets has sampled the asset and looked at its supports, so it is not refused.
    btRigidBody* added = fracture_->add(asset, options).value();
    setTouch(*added, body.touch);
}

btRigidBody* PlacedScene::addBall(const Ball& ball) {
    const double radius = ball.diameter_m / 2;
    const double mass_kg = ball.density_kg_m3 * 4 / 3 * pi * radius * radius * radius;
    auto sphere = std::make_unique<btSphereShape>(btScalar(radius));
    btRigidBody* body = addPlain(std::move(sphere), mass_kg, ball.position, ball.touch);
    // A fast ball must not pass a wall between two steps.
    body->setCcdMotionThreshold(btScalar(radius / 2));
    body->setCcdSweptSphereRadius(btScalar(radius / 2));
    body->setLinearVelocity(toBullet(ball.velocity));
    balls_.push_back({body, ball.diameter_m});
    return body;
}

btRigidBody* PlacedScene::addPlain(std::unique_ptr<btCollisionShape> shape, double mass_kg,
                                   const Vec3& position, const Touch& touch) {
    btVector3 inertia(0, 0, 0);
    if (mass_kg > 0) shape->calculateLocalInertia(btScalar(mass_kg), inertia);
    plain_bodies_.push_back(std::make_unique<PlainBody>(std::move(shape), mass_kg, inertia, position));
    btRigidBody* body = &plain_bodies_.back()->body;
    setTouch(*body, touch);
    world_.addRigidBody(body);
    return body;
}

}  // namespace demo
