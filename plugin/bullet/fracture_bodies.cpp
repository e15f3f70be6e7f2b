// The bodies of a FractureWorld: how they come, and how they go.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "bullet/fracture_world_impl.h"
#include "bullet/fragments/body_removal.h"
#include "bullet/fragments/body_swap.h"
#include "bullet/shapes/shapes.h"
#include "bullet/world/body_checks.h"
#include "bullet/world/conversions.h"
#include "bullet/world/world_internals.h"
#include "fracture/can_break.h"

namespace sherd {

namespace {

void setUp(OwnedBody& owned, const btTransform& body_from_asset, const BodyOptions& options) {
    btRigidBody& body = *owned.body;
    const btTransform place = options.start * body_from_asset.inverse();
    placeBody(owned, place, place, body_from_asset);
    if (options.motion_state) {
        options.motion_state->setWorldTransform(place);
        body.setMotionState(options.motion_state);
    }
    body.setLinearVelocity(options.velocity);
    body.setAngularVelocity(options.angular_velocity);
    body.setCenterOfMassTransform(place);  // of which setMotionState may have made another
    body.setUserPointer(options.user_pointer);
    body.setUserIndex(options.user_index);
}

/// Bullet squares masses, in single precision.
Status checkMass(double kilograms) {
    constexpr double least_kg = 1e-12, most_kg = 1e12;
    if (kilograms >= least_kg && kilograms <= most_kg) return success();
    std::ostringstream sentence;
    sentence << "the body would weigh " << kilograms << " kg, and Bullet can move bodies from " << least_kg
             << " to " << most_kg << " kg; check the material's density_kg_m3 and the unit of the mesh";
    return Error{sentence.str()};
}

}  // namespace

FractureWorld::Impl::Impl(btDiscreteDynamicsWorld& world)
    : world_(world),
      piece_contacts_(*world.getDispatcher()),
      decorator_(world, *this),
      integration_hook_(world, *this) {
    if (decorator_.isFirst()) markBetweenSteps(world_);  // otherwise the others have kept account
}

FractureWorld::Impl::~Impl() {
    const InsideStep guard(world_);
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    for (const auto& breakable : breakables_.all()) {
        if (!breakable->ownedHere()) continue;
        breakable->in_world ? removeFromWorld(world_, *breakable) : detachFromWorld(world_, *breakable);
    }
}

void FractureWorld::Impl::release(std::unique_ptr<Impl> impl) {
    impl->released_ = true;
    deleteReleased(*impl.release());
}

void FractureWorld::Impl::deleteReleased(Impl& impl) {
    if (!impl.insideStep())
        impl.decorator_.forEachListener([](StepListener& hook) { hook.deleteIfReleased(); });
}

void FractureWorld::Impl::deleteIfReleased() {
    if (released_ && !insideStep()) delete this;
}

/// Says why nothing can break in the world as it is.
Status FractureWorld::Impl::checkHook() const {
    if (const Status usable = checkWorld(world_); !usable) return usable;
    if (!decorator_.inPlace())
        return Error{
            "bodies cannot break in this world any more: its constraint solver was set after the "
            "FractureWorld was made; make that after setConstraintSolver"};
    return success();
}

/// Once for each body: an app that does not hear of it only sees that nothing breaks.
void FractureWorld::Impl::tellWhatCannotBreak() {
    const bool is_hooked = decorator_.inPlace();
    if (!is_hooked) {  // then nothing has told which bodies are gone
        breakables_.dropReplaced(world_.getCollisionObjectArray());
        breakables_.syncWithWorld(world_.getCollisionObjectArray());
    }
    for (const auto& breakable : breakables_.all()) {
        if (!breakable->in_world || breakable->body->isKinematicObject()) continue;
        const bool can_break = is_hooked && breakable->canBeStruck();
        if (std::exchange(breakable->told_unbreakable, !can_break) || can_break) continue;
        log_.addUnbreakable(
            *breakable,
            is_hooked ? "nothing breaks this body while its mass is 0, which it was set to after it was "
                        "added; a static body breaks where it has BodyOptions::supports"
                      : checkHook().error());
    }
}

Breakable& FractureWorld::Impl::registerBreakable(std::unique_ptr<Breakable> breakable) {
    breakable->serial = next_serial_++;
    breakable->inner_ball = innerBall(*breakable->body->getCollisionShape());
    breakable->noteLeastEnergy();
    return breakables_.add(std::move(breakable));
}

Result<btRigidBody*> FractureWorld::Impl::add(const BreakableAsset& free_asset, const BodyOptions& options) {
    if (const Status usable = checkHook(); !usable) return Error{usable.error()};
    if (insideStep())
        return Error{"a body cannot be added while the world is inside a step; add it after stepSimulation"};
    if (const Status valid = checkOptions(options); !valid) return Error{valid.error()};
    const Result<BreakableAsset> held =
        options.supports.empty() ? free_asset : free_asset.anchored(options.supports);
    if (!held) return Error{held.error()};
    // What a blow on another body leaves behind must not tell how one on this is decided.
    const bool has_own_factor = keepsFactorForAWhile(*held.value().solid());
    const BreakableAsset asset =
        has_own_factor ? BreakableAsset(held.value().solid()->unsolved()) : held.value();
    const bool is_static = asset.solid()->isAnchored();
    if (is_static && !(options.velocity.isZero() && options.angular_velocity.isZero()))
        return Error{"a body with supports is static, so its velocities must be 0"};
    if (!is_static)
        if (const Status usable = checkMass(asset.mass()); !usable) return Error{usable.error()};
    const ThreadsAsAllowed threads(*this);
    const auto sampling = asset.solid()->discretisation();
    if (!sampling) return Error{sampling.error()};
    auto breakable = std::make_unique<Breakable>(
        options.seed ? asset.ofBody(*options.seed) : asset,
        fractureSettingsFor(asset, options.fracture ? *options.fracture : asset.settings().fracture));
    const auto shape = shapes_.shapeOf(held.value().solid(), ShapeChoice(*breakable->fracture));
    if (!shape) return Error{shape.error()};
    if (asset.solid()->prepared()) asset.solid()->prepareSurface();  // a baked one has none
    breakable->owned = makeRigidBody(*asset.solid(), shape.value(), is_static ? 0 : 1);
    breakable->body = breakable->owned.body.get();
    breakable->body_from_asset = principalFrame(asset.solid()->moments()).body_from_asset;
    breakable->filter = CollisionFilter::usual(is_static);
    breakable->name = options.name;
    breakable->seed = options.seed;
    // With a seed the body's own asset is another one.
    if (!options.supports.empty()) breakable->of_all_alike = std::make_shared<const BreakableAsset>(asset);
    breakable->prepared_free = free_asset.prepared() && !asset.prepared();
    return putIntoWorld(std::move(breakable), options);
}

/// Bullet and the body's motion state call the app meanwhile.
Result<btRigidBody*> FractureWorld::Impl::putIntoWorld(std::unique_ptr<Breakable> breakable,
                                                       const BodyOptions& options) {
    btRigidBody* const body = breakable->body;
    {
        const InsideStep guard(world_);
        setUp(breakable->owned, breakable->body_from_asset, options);
        breakable->just_added = any_just_added_ = true;
        const CollisionFilter usual = breakable->filter;
        registerBreakable(std::move(breakable));
        world_.addRigidBody(body, options.collision_group.value_or(usual.group),
                            options.collision_mask.value_or(usual.mask));
    }
    finishBetweenSteps();  // what the app asked for meanwhile
    if (released_) return Error{"the FractureWorld was destroyed by a callback while the body was added"};
    return body;
}

Status FractureWorld::Impl::refusal(btRigidBody* body) const {
    if (const Status usable = checkHook(); !usable) return usable;
    if (insideStep())
        return Error{
            "a body cannot be made breakable while the world is inside a step; do it after stepSimulation"};
    if (!body) return Error{"there is no body to make breakable (nullptr)"};
    if (!isInWorld(world_, body))
        return Error{"the body is not in this world; add it with addRigidBody first"};
    if (breakables_.find(body)) return Error{"the body is breakable already"};
    bool has_owner = false;
    decorator_.forEachListener(
        [&](const StepListener& hook) { has_owner = has_owner || hook.isBreakable(*body); });
    if (has_owner) return Error{"the body is breakable already, by another FractureWorld of this world"};
    if (!body->getCollisionShape()) return Error{"the body has no collision shape; give it one first"};
    if (!std::isfinite(body->getInvMass()) || !isFinite(body->getInvInertiaDiagLocal()) ||
        !isFinite(body->getWorldTransform().getOrigin()) ||
        !fromBullet(body->getWorldTransform().getBasis()).allFinite())
        return Error{
            "the body's mass, inertia or place is not a finite number; set them with setMassProps and "
            "setCenterOfMassTransform"};
    if (body->isKinematicObject())
        return Error{"the body is kinematic; only dynamic and static bodies can break"};
    if (giveToken(*body) == no_token)
        return Error{
            "the body's extension pointer (internalSetExtensionPointer), by which Sherd knows it, is used by "
            "something else; use the user pointer for data of the app's"};
    return success();
}

Status FractureWorld::Impl::makeBreakable(btRigidBody* body, const Material& material,
                                          const Settings& settings, const BreakableOptions& options) {
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    if (const Status refused = refusal(body); !refused) return refused;
    const ThreadsAsAllowed threads(*this);
    auto parts = convexParts(*body->getCollisionShape());
    if (!parts) return Error{parts.error()};
    if (body->getInvMass() == 0 && options.supports.empty())
        return Error{
            "the body is static, so it can break only where something holds it: name the parts of its "
            "surface "
            "that are held (BreakableOptions::supports), or give it a mass"};
    const double mass_kg = body->getInvMass() > 0 ? 1 / double(body->getInvMass()) : 0;
    const auto alike =
        assets_.assetOf(std::move(parts).value(), mass_kg, material, settings, options.supports);
    if (!alike) return Error{alike.error()};
    const auto& [of_all, made_of] = alike.value();
    const BreakableAsset asset = options.seed ? of_all->ofBody(*options.seed) : *of_all;
    auto breakable = std::make_unique<Breakable>(asset, fractureSettingsFor(asset, settings.fracture));
    breakable->of_all_alike = of_all;
    breakable->made_of = made_of;
    breakable->body = body;
    breakable->name = options.name;
    breakable->seed = options.seed;
    registerBreakable(std::move(breakable));
    return success();
}

void FractureWorld::Impl::remove(btRigidBody* body) {
    const BodyToken token = tokenToRemove(body);
    if (token == no_token) return;
    requests_.add({body, token});
    if (!insideStep()) finishBetweenSteps();
}

/// Of a breakable body, or of one that broke in the current step; no_token for others.
BodyToken FractureWorld::Impl::tokenToRemove(const btRigidBody* body) const {
    if (const Breakable* breakable = breakables_.find(body)) return breakable->token;
    for (const QueuedEvent& queued : log_.ofStep())
        if (queued.broken && queued.broken->body == body) return queued.broken->token;
    return no_token;
}

bool FractureWorld::Impl::isToBeRemoved(const Breakable& breakable) const {
    return requests_.isToBeRemoved(breakable.token);
}

void FractureWorld::Impl::removeNow(const AppRequests::Removal& removal) {
    std::unique_ptr<Breakable> breakable = breakables_.take(removal.token);
    for (QueuedEvent& queued : log_.ofStep()) {
        auto& fragments = queued.event.fragments;
        fragments.erase(std::remove(fragments.begin(), fragments.end(), removal.body), fragments.end());
        // A body that has broken in this step: what it broke into.
        if (!queued.broken || queued.broken->token != removal.token) continue;
        for (btRigidBody* fragment : std::exchange(fragments, {}))
            removeNow({fragment, tokenToRemove(fragment)});
    }
    if (!breakable || !breakable->ownedHere()) return;  // an app's body is not breakable any more, no less
    if (isInWorld(world_, breakable->body))
        removeFromWorld(world_, *breakable);
    else
        detachFromWorld(world_, *breakable);
    to_delete_.push_back(std::move(breakable));
}

BlowCounts FractureWorld::Impl::counts() const {
    BlowCounts counts = counts_;
    counts.events_dropped = log_.leftOut();
    return counts;
}

std::vector<btRigidBody*> FractureWorld::Impl::bodies() {
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    std::vector<btRigidBody*> result;
    for (const auto& breakable : breakables_.all())
        if (breakable->in_world) result.push_back(breakable->body);
    return result;
}

}  // namespace sherd
