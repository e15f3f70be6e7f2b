#include "prototype/hall.h"

#include <algorithm>
#include <utility>

#include "viewer/conversions.h"
#include "viewer/throws.h"

namespace prototype {
namespace {

using demo::toBullet;

constexpr float friction = 0.8f, restitution = 0.25f;
constexpr float ball_kg = 2.5f, ball_speed_m_s = 11;
constexpr std::size_t most_balls = 10;

}  // namespace

/// A body with what it needs to live.
struct Hall::Rigid {
    Rigid(std::unique_ptr<btCollisionShape> its_shape, btCollisionShape& shape, float mass_kg,
          const btVector3& at)
        : owned_shape(std::move(its_shape)),
          motion(btTransform(btQuaternion::getIdentity(), at)),
          body(btRigidBody::btRigidBodyConstructionInfo(mass_kg, &motion, &shape)) {
        btVector3 inertia(0, 0, 0);
        if (mass_kg > 0) shape.calculateLocalInertia(mass_kg, inertia);
        body.setMassProps(mass_kg, inertia);
        body.setFriction(friction);
        body.setRestitution(restitution);
    }

    std::unique_ptr<btCollisionShape> owned_shape;
    btDefaultMotionState motion;
    btRigidBody body;
};

Hall::Hall(const Level& level) {
    world_.setGravity(btVector3(0, 0, -9.81f));
    addBox(btVector3(0, 0, -0.5f), btVector3(40, 40, 1));
    for (const Block& block : level.blocks) addBox(toBullet(block.centre), toBullet(block.size));
}

Hall::~Hall() {
    for (const auto& ball : balls_) world_.removeRigidBody(&ball->body);
    for (const auto& block : blocks_) world_.removeRigidBody(&block->body);
}

void Hall::addBox(const btVector3& centre, const btVector3& size) {
    auto shape = std::make_unique<btBoxShape>(size / 2);
    btCollisionShape& box = *shape;
    blocks_.push_back(std::make_unique<Rigid>(std::move(shape), box, 0.0f, centre));
    world_.addRigidBody(&blocks_.back()->body);
}

btVector3 Hall::aimOf(const render::Ray& ray) const {
    constexpr float into_nothing_m = 6;
    const demo::RayHit hit = demo::castRay(world_, ray);
    return hit.body ? hit.point : toBullet(ray.origin) + into_nothing_m * toBullet(ray.direction);
}

void Hall::throwBall(const render::Ray& ray) {
    const btVector3 from = toBullet(ray.origin) + 0.3f * toBullet(ray.direction) - btVector3(0, 0, 0.25f);
    const btVector3 aim = aimOf(ray);
    const float seconds = std::max((aim - from).length() / ball_speed_m_s, 0.02f);
    balls_.push_back(std::make_unique<Rigid>(nullptr, ball_shape_, ball_kg, from));
    btRigidBody& body = balls_.back()->body;
    // A fast ball must not pass a pane between two steps.
    body.setCcdMotionThreshold(ball_radius / 2);
    body.setCcdSweptSphereRadius(ball_radius / 2);
    body.setRollingFriction(0.01f);
    body.setLinearVelocity((aim - from) / seconds - world_.getGravity() * seconds / 2);
    world_.addRigidBody(&body);
}

void Hall::removeBall(const btRigidBody* body) {
    const auto found =
        std::find_if(balls_.begin(), balls_.end(), [body](const auto& ball) { return &ball->body == body; });
    if (found == balls_.end()) return;
    world_.removeRigidBody(&(*found)->body);
    balls_.erase(found);
}

void Hall::removeOldBalls() {
    constexpr float furthest_m = 7;
    while (balls_.size() > most_balls) removeBall(&balls_.front()->body);
    for (std::size_t i = balls_.size(); i-- > 0;) {
        const btRigidBody& body = balls_[i]->body;
        if (body.getCenterOfMassPosition().length() > furthest_m) removeBall(&body);
    }
}

std::vector<btTransform> Hall::balls() const {
    std::vector<btTransform> places;
    for (const auto& ball : balls_) places.push_back(ball->motion.m_graphicsWorldTrans);
    return places;
}

}  // namespace prototype
