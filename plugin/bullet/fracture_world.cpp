#include <sherd/fracture_world.h>

#include <algorithm>

#include "bullet/body_swap.h"
#include "bullet/fracture_world_impl.h"
#include "bullet/shapes.h"
#include "geometry/mass_properties.h"
#include "geometry/solid_union.h"

namespace sherd {

namespace {

// Bullet sets the step count to 0 when a step begins and never reads it, so another value marks the solve as
// done.
constexpr int solved = 1;

bool isIn(const btDiscreteDynamicsWorld& world, const btRigidBody* body) {
    const auto& objects = world.getCollisionObjectArray();
    return objects.findLinearSearch(const_cast<btRigidBody*>(body)) != objects.size();
}

}  // namespace

FractureWorld::Impl::Impl(btDiscreteDynamicsWorld& world) : world_(world), decorator_(world, *this) {
    markStepDone();
}

FractureWorld::Impl::~Impl() {
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    for (const auto& breakable : breakables_.all())
        if (breakable->ownedHere() && breakable->in_world) removeFromWorld(world_, *breakable->body);
    world_.getDispatchInfo().m_stepCount = 0;
}

bool FractureWorld::Impl::insideStep() const {
    return world_.getDispatchInfo().m_stepCount != solved;
}

void FractureWorld::Impl::markStepDone() {
    world_.getDispatchInfo().m_stepCount = solved;
}

Breakable& FractureWorld::Impl::registerBreakable(std::unique_ptr<Breakable> breakable) {
    breakable->serial = next_serial_++;
    return breakables_.add(std::move(breakable));
}

btRigidBody* FractureWorld::Impl::add(const BreakableAsset& asset, const btTransform& start) {
    if (insideStep()) {
        last_error_ = "a body cannot be added while the world is inside a step; add it after stepSimulation";
        return nullptr;
    }
    const Result<std::vector<Box>> boxes = collisionBoxes(*asset.solid());
    if (!boxes) {
        last_error_ = boxes.error();
        return nullptr;
    }
    last_error_.clear();
    auto breakable = std::make_unique<Breakable>(asset);
    breakable->owned = makeRigidBody(*asset.solid(), boxes.value());
    breakable->body = breakable->owned.body.get();
    breakable->body_from_asset = principalFrame(asset.solid()->moments()).body_from_asset;
    breakable->body->setCenterOfMassTransform(start * breakable->body_from_asset.inverse());
    world_.addRigidBody(breakable->body);
    return registerBreakable(std::move(breakable)).body;
}

Status FractureWorld::Impl::refusal(const btRigidBody* body) const {
    if (insideStep())
        return Error{
            "a body cannot be made breakable while the world is inside a step; do it after stepSimulation"};
    if (!body) return Error{"there is no body to make breakable (nullptr)"};
    if (!isIn(world_, body)) return Error{"the body is not in this world; add it with addRigidBody first"};
    if (breakables_.find(body)) return Error{"the body is breakable already"};
    if (body->isStaticOrKinematicObject() || body->getInvMass() == 0)
        return Error{"the body is static or kinematic and has no mass; only dynamic bodies can break"};
    return success();
}

Status FractureWorld::Impl::makeBreakable(btRigidBody* body, const Material& material,
                                          const Settings& settings) {
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    if (const Status refused = refusal(body); !refused) return refused;
    const auto parts = convexParts(*body->getCollisionShape());
    if (!parts) return Error{parts.error()};
    const auto surface = uniteConvexParts(parts.value());
    if (!surface) return Error{surface.error()};
    Material own = material;
    own.density_kg_m3 = 1 / (body->getInvMass() * solidMoments(surface.value()).volume);
    const auto asset = BreakableAsset::fromMesh(surface.value(), own, settings);
    if (!asset) return Error{asset.error()};
    auto breakable = std::make_unique<Breakable>(asset.value());
    breakable->body = body;
    registerBreakable(std::move(breakable));
    return success();
}

void FractureWorld::Impl::remove(btRigidBody* body) {
    const Breakable* breakable = breakables_.find(body);
    if (!breakable || !breakable->ownedHere()) return;
    if (insideStep())
        to_remove_.push_back(body);
    else
        removeNow(body);
}

void FractureWorld::Impl::removeNow(btRigidBody* body) {
    std::unique_ptr<Breakable> breakable = breakables_.take(body);
    if (!breakable) return;  // removal was requested twice, or the body broke in between
    if (isIn(world_, body)) removeFromWorld(world_, *body);
    to_delete_.push_back(std::move(breakable));
}

std::vector<BreakEvent> FractureWorld::Impl::takeEvents() {
    std::move(broken_.begin(), broken_.end(), std::back_inserter(to_delete_));
    broken_.clear();
    return std::exchange(events_, {});
}

std::vector<btRigidBody*> FractureWorld::Impl::bodies() {
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    std::vector<btRigidBody*> result;
    for (const auto& breakable : breakables_.all())
        if (breakable->in_world) result.push_back(breakable->body);
    return result;
}

FractureWorld::FractureWorld(btDiscreteDynamicsWorld* world) : impl_(std::make_unique<Impl>(*world)) {}
FractureWorld::~FractureWorld() = default;

btRigidBody* FractureWorld::add(const BreakableAsset& asset, const btTransform& start) {
    return impl_->add(asset, start);
}

Status FractureWorld::makeBreakable(btRigidBody* body, const Material& material, const Settings& settings) {
    return impl_->makeBreakable(body, material, settings);
}

void FractureWorld::remove(btRigidBody* body) {
    impl_->remove(body);
}
std::vector<BreakEvent> FractureWorld::events() {
    return impl_->takeEvents();
}
BlowCounts FractureWorld::counts() const {
    return impl_->counts();
}
std::vector<btRigidBody*> FractureWorld::bodies() const {
    return impl_->bodies();
}

const BreakableAsset* FractureWorld::asset(const btRigidBody* body) const {
    const Breakable* breakable = impl_->breakables().find(body);
    return breakable ? &breakable->asset : nullptr;
}

btTransform FractureWorld::assetTransform(const btRigidBody* body) const {
    const Breakable* breakable = impl_->breakables().find(body);
    return breakable ? breakable->placed(body->getWorldTransform()) : btTransform::getIdentity();
}

const std::string& FractureWorld::lastError() const {
    return impl_->lastError();
}

}  // namespace sherd
