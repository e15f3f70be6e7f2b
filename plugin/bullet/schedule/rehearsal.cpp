#include "bullet/schedule/rehearsal.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <unordered_set>
#include <utility>

#include "bullet/ground/ground_contact.h"
#include "bullet/ground/steady_contacts.h"
#include "bullet/island/contact_motion.h"
#include "bullet/world/anisotropic_friction.h"
#include "bullet/world/extra_contacts.h"
#include "bullet/world/pair_filter.h"

namespace sherd {

namespace {

void copyCollision(const btCollisionObject& from, btCollisionObject& to) {
    to.setFriction(from.getFriction());
    to.setRollingFriction(from.getRollingFriction());
    to.setSpinningFriction(from.getSpinningFriction());
    to.setRestitution(from.getRestitution());
    to.setContactStiffnessAndDamping(from.getContactStiffness(), from.getContactDamping());  // sets a flag
    // The app's callback for contacts of such objects would be asked of bodies that it does not know.
    to.setCollisionFlags(from.getCollisionFlags() & ~btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    to.setContactProcessingThreshold(from.getContactProcessingThreshold());
    to.setAnisotropicFriction(from.getAnisotropicFriction(), anisotropicFrictionMode(from));
    to.setCcdMotionThreshold(from.getCcdMotionThreshold());
    to.setCcdSweptSphereRadius(from.getCcdSweptSphereRadius());
    to.forceActivationState(from.getActivationState());
    to.setDeactivationTime(from.getDeactivationTime());
}

std::unique_ptr<btRigidBody> standInFor(const btRigidBody& body, const Role& role) {
    const btScalar mass = body.getInvMass() > 0 ? 1 / body.getInvMass() : btScalar(0);
    btRigidBody::btRigidBodyConstructionInfo info(
        mass, nullptr, const_cast<btCollisionShape*>(body.getCollisionShape()), body.getLocalInertia());
    info.m_startWorldTransform = body.getWorldTransform();
    auto stand_in = std::make_unique<btRigidBody>(info);
    copyCollision(body, *stand_in);
    stand_in->setInvInertiaDiagLocal(body.getInvInertiaDiagLocal());
    stand_in->updateInertiaTensor();
    stand_in->setDamping(role.driven ? 0 : body.getLinearDamping(), body.getAngularDamping());
    stand_in->setSleepingThresholds(body.getLinearSleepingThreshold(), body.getAngularSleepingThreshold());
    stand_in->setLinearFactor(body.getLinearFactor());
    stand_in->setAngularFactor(body.getAngularFactor());
    stand_in->setLinearVelocity(body.getLinearVelocity());
    stand_in->setAngularVelocity(body.getAngularVelocity());
    stand_in->setFlags(body.getFlags() | BT_DISABLE_WORLD_GRAVITY);
    stand_in->setGravity(role.driven.value_or(body.getGravity()));
    return stand_in;
}

std::unique_ptr<btCollisionObject> standInFor(const btCollisionObject& object) {
    auto stand_in = std::make_unique<btCollisionObject>();
    stand_in->setCollisionShape(const_cast<btCollisionShape*>(object.getCollisionShape()));
    stand_in->setWorldTransform(object.getWorldTransform());
    copyCollision(object, *stand_in);
    return stand_in;
}

/// What decides whether and how the stand-in of a breakable body is struck.
std::unique_ptr<Breakable> standInFor(const Breakable& breakable) {
    auto stand_in = std::make_unique<Breakable>(breakable.asset, breakable.fracture);
    stand_in->body_from_asset = breakable.body_from_asset;
    stand_in->serial = breakable.serial;
    stand_in->unbreakable_until_s = breakable.unbreakable_until_s;
    stand_in->young_until_s = breakable.young_until_s;
    stand_in->generation = breakable.generation;
    stand_in->least_energy_j = breakable.least_energy_j;
    stand_in->inner_ball = breakable.inner_ball;
    stand_in->way = breakable.way;
    return stand_in;
}

}  // namespace

bool Rehearsal::mayRehearse(btDiscreteDynamicsWorld& world) {
    using Usual = btManifoldResult;
    const bool is_silent =
        !gContactProcessedCallback && !gContactStartedCallback && !gContactEndedCallback &&
        gCalculateCombinedRestitutionCallback == Usual::calculateCombinedRestitution &&
        gCalculateCombinedFrictionCallback == Usual::calculateCombinedFriction &&
        gCalculateCombinedRollingFrictionCallback == Usual::calculateCombinedRollingFriction &&
        gCalculateCombinedSpinningFrictionCallback == Usual::calculateCombinedSpinningFriction &&
        gCalculateCombinedContactDampingCallback == Usual::calculateCombinedContactDamping &&
        gCalculateCombinedContactStiffnessCallback == Usual::calculateCombinedContactStiffness;
    const auto* dispatcher = dynamic_cast<const btCollisionDispatcher*>(world.getDispatcher());
    return is_silent && dispatcher &&
           dispatcher->getNearCallback() == btCollisionDispatcher::defaultNearCallback;
}

Rehearsal::Rehearsal(btDiscreteDynamicsWorld& world, const BirthOverlaps& overlaps,
                     const RecentStrikes& recent_strikes, const std::vector<Role>& roles, double time_s)
    : of_world_(world),
      time_step_s_(world.getSolverInfo().m_timeStep),
      time_s_(time_s),
      dispatcher_(static_cast<btCollisionDispatcher*>(world.getDispatcher())->getCollisionConfiguration()),
      piece_contacts_(dispatcher_),
      world_(&dispatcher_, &broadphase_, &solver_, nullptr),
      decorator_(world_, *this) {
    dispatcher_.setDispatcherFlags(
        static_cast<btCollisionDispatcher*>(world.getDispatcher())->getDispatcherFlags());
    world_.getSolverInfo() = world.getSolverInfo();
    btDispatcherInfo& dispatch = world_.getDispatchInfo();
    dispatch = world.getDispatchInfo();
    dispatch.m_debugDraw = nullptr;
    world_.setGravity(world.getGravity());
    world_.setForceUpdateAllAabbs(world.getForceUpdateAllAabbs());
    world_.setApplySpeculativeContactRestitution(world.getApplySpeculativeContactRestitution());
    world_.getSimulationIslandManager()->setSplitIslands(
        world.getSimulationIslandManager()->getSplitIslands());
    broadphase_.getOverlappingPairCache()->setOverlapFilterCallback(this);
    for (const Role& role : roles) add(role);
    const auto standInOf = [&](const btCollisionObject* object) {
        const auto found = stand_in_of_.find(object);
        return found == stand_in_of_.end() ? nullptr : found->second;
    };
    overlaps_.copy(overlaps, standInOf);
    recent_strikes_ = recent_strikes.ofOthers(standInOf);
    noteContacts(world);
}

void Rehearsal::add(const Role& role) {
    const btCollisionObject& object = *role.object;
    const btBroadphaseProxy& proxy = *object.getBroadphaseHandle();
    const auto note = [&](btCollisionObject& stand_in) {
        stand_in_of_[&object] = &stand_in;
        original_of_[&stand_in] = &object;
    };
    const btRigidBody* body = btRigidBody::upcast(&object);
    if (!body) {
        stand_ins_.push_back(standInFor(object));
        note(*stand_ins_.back());
        world_.addCollisionObject(stand_ins_.back().get(), proxy.m_collisionFilterGroup,
                                  proxy.m_collisionFilterMask);
        return;
    }
    std::unique_ptr<btRigidBody> stand_in = standInFor(*body, role);
    note(*stand_in);
    world_.addRigidBody(stand_in.get(), proxy.m_collisionFilterGroup, proxy.m_collisionFilterMask);
    if (role.breakable) {
        std::unique_ptr<Breakable> breakable = standInFor(*role.breakable);
        breakable->body = stand_in.get();
        if (role.breakable->ownedHere()) {
            breakable->owned.shape = role.breakable->owned.shape;
            breakable->owned.body = std::move(stand_in);
        }
        original_breakable_of_[&breakables_.add(std::move(breakable))] = role.breakable;
    }
    if (stand_in) stand_ins_.push_back(std::move(stand_in));
}

/// What the app lets push each other does so here.
bool Rehearsal::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
    const auto *of_a = original(static_cast<const btCollisionObject*>(a->m_clientObject)),
               *of_b = original(static_cast<const btCollisionObject*>(b->m_clientObject));
    return mayMeet(of_world_, *of_a, *of_b);
}

void Rehearsal::noteContacts(btDiscreteDynamicsWorld& world) {
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const auto a = stand_in_of_.find(manifold.getBody0()), b = stand_in_of_.find(manifold.getBody1());
        if (a == stand_in_of_.end() || b == stand_in_of_.end()) continue;
        KnownContacts known{a->second, b->second, {}};
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            known.points.push_back(manifold.getContactPoint(p));
            known.points.back().m_userPersistentData = nullptr;  // the app's, of another contact
        }
        if (!known.points.empty()) known_contacts_.push_back(std::move(known));
    }
}

/// Bullet finds a contact a step between some shapes: what it has found so far is part of what comes. Two
/// bodies may have several manifolds, one for each pair of children of their shapes.
void Rehearsal::takeOverContacts() {
    std::unordered_set<const btPersistentManifold*> taken;
    for (KnownContacts& known : std::exchange(known_contacts_, {})) {
        if (!known.a->isActive() && !known.b->isActive()) {  // Bullet looks for none until one is awake
            known_contacts_.push_back(std::move(known));
            continue;
        }
        btPersistentManifold* of_pair = nullptr;
        for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
            btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
            if (manifold.getBody0() != known.a || manifold.getBody1() != known.b || taken.count(&manifold))
                continue;
            const bool is_of_children =
                manifold.getNumContacts() > 0 &&
                manifold.getContactPoint(0).m_index0 == known.points.front().m_index0 &&
                manifold.getContactPoint(0).m_index1 == known.points.front().m_index1;
            if (is_of_children || (!of_pair && manifold.getNumContacts() == 0)) of_pair = &manifold;
            if (is_of_children) break;
        }
        if (!of_pair) continue;
        taken.insert(of_pair);
        of_pair->clearManifold();
        for (const btManifoldPoint& point : known.points) of_pair->addManifoldPoint(point);
        of_pair->refreshContactPoints(known.a->getWorldTransform(), known.b->getWorldTransform());
    }
}

std::vector<StruckBreakable> Rehearsal::step() {
    struck_.clear();
    world_.stepSimulation(time_step_s_, 0, time_step_s_);
    stopAtGround(world_, breakables_, before_, moved_ground_);
    for (StruckBreakable& struck : struck_) {
        struck.breakable = original_breakable_of_.at(struck.breakable);
        for (const btCollisionObject*& partner : struck.partners) partner = original(partner);
        struck.striker = original(struck.striker);
    }
    return std::move(struck_);
}

BodyState Rehearsal::stateOf(const btRigidBody& body) const {
    return sherd::stateOf(*btRigidBody::upcast(stand_in_of_.at(&body)));
}

const btCollisionObject* Rehearsal::original(const btCollisionObject* stand_in) const {
    const auto found = original_of_.find(stand_in);
    return found == original_of_.end() ? nullptr : found->second;
}

void Rehearsal::beforeSolve() {
    breakables_.syncWithWorld(world_.getCollisionObjectArray());
    takeOverContacts();
    overlaps_.applyAllowances(world_);
    steadyContacts(
        world_,
        {breakables_, overlaps_, [&](const auto& object) { return breakables_.isFragment(object); },
         moved_ground_.surfaces()},
        [](const btCollisionObject&) { return true; });
    std::vector<const Breakable*> bodies;
    for (const auto& breakable : breakables_.all()) bodies.push_back(breakable.get());
    addGroundContacts(world_, bodies, moved_ground_.surfaces());
    before_.take(world_);
    write_back_.begin(world_);
}

void Rehearsal::afterSolve(const btContactSolverInfo& info, btIDebugDraw*) {
    time_s_ += info.m_timeStep;
    ContactCollector collector(breakables_, before_, time_s_, info, &overlaps_, &recent_strikes_);
    feedSolvedContacts(world_, collector);
    struck_ = collector.takeStruck();
    recent_strikes_.note(struck_, time_s_, info.m_timeStep);
    write_back_.end(world_);
}

void Rehearsal::endSolve(const btContactSolverInfo&) {
    releaseExtraManifolds(world_);
}

bool Rehearsal::isBreakable(const btCollisionObject& object) const {
    return breakables_.of(object) != nullptr;
}

bool Rehearsal::isFragment(const btCollisionObject& object) const {
    return breakables_.isFragment(object);
}

}  // namespace sherd
