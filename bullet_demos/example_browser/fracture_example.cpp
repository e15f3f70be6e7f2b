#include "example_browser/fracture_example.h"

#include <CommonInterfaces/CommonParameterInterface.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace demo {
namespace {

constexpr int left_out = -1;      ///< a number of a button that nobody asks for
constexpr int right_button = 2;   ///< of the mouse
constexpr int most_substeps = 8;  ///< a frame; the scene is slower than life where they do not suffice
constexpr double degrees = 57.29577951308232;

/// The radius of the largest body about the origin of its coordinates.
double sizeOf(const SceneAssets& assets) {
    double size = 0;
    for (const sherd::BreakableAsset& asset : assets.bodies)
        for (const Vec3& vertex : asset.surface().vertices) size = std::max(size, vertex.norm());
    return size;
}

}  // namespace

FractureExample::FractureExample(GUIHelperInterface* helper, std::string scene_file, std::string meshes,
                                 Knobs& knobs)
    : CommonRigidBodyBase(helper),
      scene_file_(std::move(scene_file)),
      meshes_(std::move(meshes)),
      knobs_(knobs) {}

FractureExample::~FractureExample() = default;

void FractureExample::initPhysics() {
    m_guiHelper->setUpAxis(2);
    createEmptyDynamicsWorld();
    m_guiHelper->createPhysicsDebugDrawer(m_dynamicsWorld);
    graphics_ = std::make_unique<BodyGraphics>(*m_guiHelper);
    registerSliders(*m_guiHelper, knobs_);
    if (CommonParameterInterface* panel = m_guiHelper->getParameterInterface()) {
        ButtonParams button("start again", left_out, false);  // no switch that stays pressed
        button.m_userPointer = this;
        // The panel is in the middle of its own work then, so the next step does it.
        button.m_callback = [](int, bool, void* example) {
            static_cast<FractureExample*>(example)->is_restart_wanted_ = true;
        };
        panel->registerButtonParameter(button);
    }
    placeScene();
}

void FractureExample::exitPhysics() {
    removePickingConstraint();
    placed_.reset();  // takes its bodies out of the world, of which the base class deletes all
    graphics_.reset();
    CommonRigidBodyBase::exitPhysics();
}

void FractureExample::placeScene() {
    auto scene = sceneWith(scene_file_, knobs_);
    auto assets =
        scene ? makeAssets(scene.value(), meshes_, [](const std::string& what) { std::cerr << what << '\n'; })
              : sherd::Result<SceneAssets>(sherd::Error{scene.error()});
    if (!assets) {
        std::cerr << assets.error() << '\n';
        return;
    }
    scene_ = std::move(scene).value();
    assets_ = std::move(assets).value();
    placed_ = std::make_unique<PlacedScene>(*m_dynamicsWorld, *scene_, assets_);
    BodyGraphics::watch(*placed_);
    graphics_->addMissing(*m_dynamicsWorld, *placed_);
}

void FractureExample::removeScene() {
    removePickingConstraint();
    placed_.reset();
    graphics_->removeAll();
}

void FractureExample::restart() {
    is_restart_wanted_ = false;
    removeScene();
    placeScene();
}

void FractureExample::stepSimulation(float seconds) {
    if (is_restart_wanted_) restart();
    if (!placed_) return;
    m_dynamicsWorld->stepSimulation(seconds, most_substeps, btScalar(scene_->time_step_s));
    takeEvents();
}

void FractureExample::takeEvents() {
    for (const sherd::BlowEvent& event : placed_->fracture().takeEvents()) {
        if (event.outcome != sherd::Outcome::broke) continue;
        // Bodies that broke are there until the next step; who holds one lets it go now.
        if (event.body == m_pickedBody) removePickingConstraint();
        graphics_->remove(*event.body);
    }
    graphics_->addMissing(*m_dynamicsWorld, *placed_);
}

void FractureExample::resetCamera() {
    if (!scene_) return;
    const double size = sizeOf(assets_);
    const Vec3 along = scene_->camera.towards.normalized();
    const double yaw = std::atan2(-along.x(), along.y()) * degrees, pitch = std::asin(along.z()) * degrees;
    const Vec3& place = scene_->bodies.front().position;
    m_guiHelper->resetCamera(float(1.7 * size), float(yaw), float(pitch), float(place.x()), float(place.y()),
                             float(0.55 * size));
}

bool FractureExample::mouseButtonCallback(int button, int state, float x, float y) {
    if (button != right_button || state != 1 || !placed_)
        return CommonRigidBodyBase::mouseButtonCallback(button, state, x, y);
    const btVector3 from = cameraPosition();
    shoot(from, getRayTo(int(x), int(y)) - from);
    return true;
}

bool FractureExample::keyboardCallback(int key, int state) {
    if (key != '.' || !state || !placed_) return CommonRigidBodyBase::keyboardCallback(key, state);
    btVector3 target;
    m_guiHelper->getRenderInterface()->getActiveCamera()->getCameraTargetPosition(target);
    shoot(cameraPosition(), target - cameraPosition());
    return true;
}

void FractureExample::shoot(const btVector3& from, const btVector3& towards) {
    Ball ball;
    ball.diameter_m = scene_->balls.empty() ? 0.4 * sizeOf(assets_) : scene_->balls.front().diameter_m;
    const btVector3 velocity = knobs_.ball_speed_m_s * towards.normalized();
    ball.position = Vec3(from.x(), from.y(), from.z());
    ball.velocity = Vec3(velocity.x(), velocity.y(), velocity.z());
    placed_->addBall(ball);
    graphics_->addMissing(*m_dynamicsWorld, *placed_);
}

btVector3 FractureExample::cameraPosition() const {
    btVector3 position;
    m_guiHelper->getRenderInterface()->getActiveCamera()->getCameraPosition(position);
    return position;
}

}  // namespace demo
