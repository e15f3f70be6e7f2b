#include <sherd/fracture_world.h>

#include <stdexcept>

#include "bullet/fracture_world_impl.h"
#include "bullet/shapes/rigid_body_factory.h"

namespace sherd {

namespace {

btDiscreteDynamicsWorld& orThrow(btDiscreteDynamicsWorld* world) {
    if (!world)
        throw std::invalid_argument("FractureWorld was given no world (nullptr); make the world first.");
    return *world;
}

}  // namespace

FractureWorld::FractureWorld(btDiscreteDynamicsWorld* world)
    : impl_(std::make_unique<Impl>(orThrow(world))) {}
FractureWorld::~FractureWorld() {
    Impl::release(std::move(impl_));
}

Result<btRigidBody*> FractureWorld::add(const BreakableAsset& asset, const BodyOptions& options) {
    Impl& impl = *impl_;  // a callback of the app's may destroy this object
    auto added = impl.add(asset, options);
    Impl::deleteReleased(impl);
    return added;
}
Status FractureWorld::makeBreakable(btRigidBody* body, const Material& material, const Settings& settings,
                                    const BreakableOptions& options) {
    return impl_->makeBreakable(body, material, settings, options);
}
void FractureWorld::remove(btRigidBody* body) {
    Impl& impl = *impl_;
    impl.remove(body);
    Impl::deleteReleased(impl);
}
Status FractureWorld::applyBlow(btRigidBody* body, const Push& push) {
    return applyBlow(body, std::vector<Push>{push});
}
Status FractureWorld::applyBlow(btRigidBody* body, const std::vector<Push>& pushes) {
    Impl& impl = *impl_;
    const Status done = impl.applyBlow(body, pushes);
    Impl::deleteReleased(impl);
    return done;
}
Result<int> FractureWorld::applyBlows(const std::vector<std::pair<btRigidBody*, std::vector<Push>>>& blows) {
    Impl& impl = *impl_;
    const Result<int> struck = impl.applyBlows(blows);
    Impl::deleteReleased(impl);
    return struck;
}
void FractureWorld::onFragment(FragmentCallback callback) {
    impl_->onFragment(std::move(callback));
}
std::vector<BlowEvent> FractureWorld::takeEvents() {
    return impl_->takeEvents();
}
Status FractureWorld::setBudget(const Budget& budget) {
    return impl_->setBudget(budget);
}

const Budget& FractureWorld::budget() const {
    return impl_->budget();
}

void FractureWorld::setExecutor(Executor executor) {
    impl_->setExecutor(std::move(executor));
}

BlowCounts FractureWorld::counts() const {
    return impl_->counts();
}
WorldTimes FractureWorld::times() const {
    return impl_->times();
}
std::vector<btRigidBody*> FractureWorld::bodies() const {
    return impl_->bodies();
}

const BreakableAsset* FractureWorld::asset(const btRigidBody* body) const {
    const Breakable* breakable = impl_->breakables().find(body);
    return breakable ? &breakable->asset : nullptr;
}

std::string FractureWorld::name(const btRigidBody* body) const {
    const Breakable* breakable = impl_->breakables().find(body);
    return breakable ? breakable->name : std::string();
}

int FractureWorld::generation(const btRigidBody* body) const {
    const Breakable* breakable = impl_->breakables().find(body);
    return breakable ? breakable->generation : 0;
}

btTransform FractureWorld::assetTransform(const btRigidBody* body) const {
    const Breakable* breakable = impl_->breakables().find(body);
    return breakable ? breakable->placed(body->getWorldTransform()) : btTransform::getIdentity();
}

btTransform FractureWorld::renderTransform(const btRigidBody* body) const {
    const Breakable* breakable = impl_->breakables().find(body);
    if (!breakable) return btTransform::getIdentity();
    const btTransform body_from_asset = breakable->body_from_asset;  // a motion state is the app's code
    return renderedTransform(*body) * body_from_asset;
}

}  // namespace sherd
