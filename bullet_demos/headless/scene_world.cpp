#include "headless/scene_world.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <string>

#include "generators/mesh_store.h"
#include "scenes/box_mesh.h"

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

using Announce = std::function<void(const std::string&)>;

/// Reads and repairs it as the scene says; what was changed, and a size that is hardly meant, is announced.
sherd::Result<sherd::TriangleMesh> readMesh(const ObjFile& file, const Announce& announce) {
    const auto mesh = sherd::readObj(file.path);
    if (!mesh) return mesh;
    auto repaired = sherd::repairMesh(mesh.value(), file.repair);
    if (!repaired) return sherd::Error{file.path + ": " + repaired.error()};
    std::vector<std::string> said = repaired.value().report.sentences();
    said.push_back(sherd::sizeWarning(repaired.value().mesh));
    for (const std::string& sentence : said)
        if (announce && !sentence.empty()) announce(file.path + ": " + sentence);
    return std::move(repaired.value().mesh);
}

sherd::Result<sherd::TriangleMesh> makeSurface(const Shape& shape, const std::string& meshes,
                                               const Announce& announce) {
    if (const auto* box = std::get_if<Box>(&shape)) return boxMesh(*box);
    if (const auto* mesh = std::get_if<Generated>(&shape))
        return storedMesh(mesh->name, mesh->triangles, meshes, announce);
    return readMesh(std::get<ObjFile>(shape), announce);
}

/// The body's settings, with the strength that its surface is painted with.
sherd::Result<sherd::Settings> makeSettings(const BreakableBody& body, const sherd::TriangleMesh& surface) {
    sherd::Settings settings = body.settings;
    if (!body.painted_strength) return settings;
    const PaintedStrength& painted = *body.painted_strength;
    auto strength = sherd::strengthFromColours(surface, painted.black, painted.white);
    if (!strength) return sherd::Error{"painted_strength: " + strength.error()};
    settings.strength.field = std::move(strength).value();
    settings.strength.field_minimum = std::min(painted.black, painted.white);
    return settings;
}

sherd::Result<sherd::BreakableAsset> makeAsset(const BreakableBody& body, const std::string& meshes,
                                               const Announce& announce, double& sample_ms) {
    const auto surface = makeSurface(body.shape, meshes, announce);
    if (!surface) return sherd::Error{surface.error()};
    const auto* file = std::get_if<ObjFile>(&body.shape);
    const std::string source = file ? file->path + ": " : "";
    const auto settings = makeSettings(body, surface.value());
    if (!settings) return sherd::Error{source + settings.error()};
    auto asset = sherd::BreakableAsset::fromMesh(surface.value(), body.material, settings.value());
    if (!asset) return sherd::Error{source + asset.error()};
    const auto start = std::chrono::steady_clock::now();
    const bool is_sampled = asset.value().particleCount() > 0;
    sample_ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    // A solid that cannot be sampled gets no body in the world; `prepare` says why, before it assembles
    // anything.
    if (!is_sampled) return sherd::Error{source + asset.value().prepare().error()};
    if (body.supports.empty()) return asset;
    auto anchored = asset.value().anchored(body.supports);
    if (!anchored) return sherd::Error{source + anchored.error()};
    return anchored;
}

}  // namespace

sherd::Result<SceneAssets> makeAssets(const Scene& scene, const std::string& meshes,
                                      const Announce& announce) {
    SceneAssets assets;
    for (const BreakableBody& body : scene.bodies) {
        auto asset = makeAsset(body, meshes, announce, assets.sample_ms);
        if (!asset) return sherd::Error{asset.error()};
        assets.bodies.push_back(std::move(asset).value());
    }
    return assets;
}

SceneWorld::SceneWorld(const Scene& scene, const SceneAssets& assets) : scene_(scene) {
    world_.setGravity(toBullet(scene.gravity));
    fracture_ = std::make_unique<sherd::FractureWorld>(&world_);
    // Nobody waits for the next frame: every blow is decided in its step.
    if (!fracture_->setBudget(sherd::Budget::none())) std::abort();
    addFloor();
    for (std::size_t i = 0; i < assets.bodies.size(); ++i) addBody(scene_.bodies[i], assets.bodies[i]);
    for (const Ball& ball : scene_.balls) addBall(ball);
}

SceneWorld::~SceneWorld() {
    fracture_.reset();
    for (const auto& body : plain_bodies_) world_.removeRigidBody(body.get());
}

void SceneWorld::step() {
    const auto dt = btScalar(scene_.time_step_s);
    world_.stepSimulation(dt, 1, dt);
}

std::vector<BodyState> SceneWorld::states() const {
    std::vector<BodyState> states;
    for (const btRigidBody* body : fracture_->bodies()) {
        // Fragments inherit the user pointer of the body that they come from.
        const auto* source = static_cast<const BreakableBody*>(body->getUserPointer());
        states.push_back(
            {*fracture_->asset(body), 0, source->look, toEigen(fracture_->assetTransform(body))});
    }
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        states.push_back(
            {std::nullopt, scene_.balls[i].diameter_m, {}, toEigen(balls_[i]->getWorldTransform())});
    }
    return states;
}

void SceneWorld::addFloor() {
    constexpr double half_width_m = 20, half_depth_m = 0.5;
    auto slab = std::make_unique<btBoxShape>(toBullet(Vec3(half_width_m, half_width_m, half_depth_m)));
    addPlain(std::move(slab), 0, Vec3(0, 0, -half_depth_m), scene_.floor);
}

void SceneWorld::addBody(BreakableBody& body, const sherd::BreakableAsset& asset) {
    sherd::BodyOptions options(startOf(body, asset));
    options.velocity = toBullet(body.velocity);
    options.angular_velocity = toBullet(body.spin);
    options.user_pointer = &body;
    // makeAssets has sampled the asset and looked at its supports, so it is not refused.
    btRigidBody* added = fracture_->add(asset, options).value();
    setTouch(*added, body.touch);
}

void SceneWorld::addBall(const Ball& ball) {
    const double radius = ball.diameter_m / 2;
    const double mass_kg = ball.density_kg_m3 * 4 / 3 * pi * radius * radius * radius;
    auto sphere = std::make_unique<btSphereShape>(btScalar(radius));
    balls_.push_back(addPlain(std::move(sphere), mass_kg, ball.position, ball.touch));
    // A fast ball must not pass a wall between two steps.
    balls_.back()->setCcdMotionThreshold(btScalar(radius / 2));
    balls_.back()->setCcdSweptSphereRadius(btScalar(radius / 2));
    balls_.back()->setLinearVelocity(toBullet(ball.velocity));
}

btRigidBody* SceneWorld::addPlain(std::unique_ptr<btCollisionShape> shape, double mass_kg,
                                  const Vec3& position, const Touch& touch) {
    btVector3 inertia(0, 0, 0);
    if (mass_kg > 0) shape->calculateLocalInertia(btScalar(mass_kg), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass_kg), nullptr, shape.get(), inertia);
    info.m_startWorldTransform.setOrigin(toBullet(position));
    plain_bodies_.push_back(std::make_unique<btRigidBody>(info));
    shapes_.push_back(std::move(shape));
    setTouch(*plain_bodies_.back(), touch);
    world_.addRigidBody(plain_bodies_.back().get());
    return plain_bodies_.back().get();
}

}  // namespace demo
