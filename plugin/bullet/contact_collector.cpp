#include "bullet/contact_collector.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>

#include "bullet/conversions.h"
#include "bullet/multi_body_state.h"
#include "bullet/shapes.h"
#include "bullet/world_internals.h"

namespace sherd {

namespace {

constexpr double resting_steps = 2;  // of free fall: slower contacts are those of a body at rest

/// Before and after the solve, at one point.
struct PointMotion {
    btVector3 before = btVector3(0, 0, 0), after = btVector3(0, 0, 0);
    btScalar inverse_mass = 0;       // n . K n
    btScalar free_acceleration = 0;  // along the normal, by gravity and what the app applies
};

PointMotion motionAt(const btCollisionObject& object, const StepSnapshot& snapshot, const btVector3& point,
                     const btVector3& normal) {
    PointMotion motion;
    if (const btRigidBody* body = btRigidBody::upcast(&object)) {
        const BodyState* state = snapshot.find(&object);
        const btVector3 origin = state ? state->transform.getOrigin() : body->getCenterOfMassPosition();
        motion.after = body->getLinearVelocity() + body->getAngularVelocity().cross(point - origin);
        motion.before = state ? state->velocityAt(point) : motion.after;
        if (body->isStaticOrKinematicObject()) return motion;
        motion.inverse_mass = body->computeImpulseDenominator(point, normal);
        motion.free_acceleration = std::abs(body->getTotalForce().dot(normal)) * body->getInvMass();
    } else if (linkMotion(object, point, motion.before, motion.inverse_mass)) {
        motion.after = motion.before;  // Bullet adds what the solve gave to multi-bodies only later
    }
    return motion;
}

/// Predictive contacts (continuous collision) put the centre of the swept sphere where other contacts have
/// the point.
void moveToSurface(btManifoldPoint& point, const btCollisionObject& swept) {
    const btVector3 to_surface = -point.m_normalWorldOnB * swept.getCcdSweptSphereRadius();
    point.m_positionWorldOnA += to_surface;
    point.m_positionWorldOnB += to_surface;
}

void feedManifold(btPersistentManifold& manifold, bool predictive, ContactCollector& collector) {
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    const btCollisionObjectWrapper wrapper_a(nullptr, a->getCollisionShape(), a, a->getWorldTransform(), -1,
                                             -1);
    const btCollisionObjectWrapper wrapper_b(nullptr, b->getCollisionShape(), b, b->getWorldTransform(), -1,
                                             -1);
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint point = manifold.getContactPoint(i);
        if (point.getDistance() > manifold.getContactProcessingThreshold()) continue;
        if (predictive) {
            moveToSurface(point, *a);
            point.m_index0 = point.m_index1 = -1;
        }
        collector.addSingleResult(point, &wrapper_a, point.m_partId0, point.m_index0, &wrapper_b,
                                  point.m_partId1, point.m_index1);
    }
}

}  // namespace

BodyState stateOf(const btRigidBody& body) {
    return {&body, body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity()};
}

ContactCollector::ContactCollector(const BreakableRegistry& breakables, const StepSnapshot& before,
                                   double time_s, const btContactSolverInfo& info)
    : breakables_(breakables),
      before_(before),
      time_s_(time_s),
      time_step_s_(info.m_timeStep),
      two_friction_directions_((info.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS) != 0) {}

btScalar ContactCollector::addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* wrapper_a,
                                           int, int index_a, const btCollisionObjectWrapper* wrapper_b, int,
                                           int index_b) {
    if (point.m_appliedImpulse <= 0) return 0;
    const btVector3 normal = point.m_normalWorldOnB;
    btVector3 impulse =
        normal * point.m_appliedImpulse + point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1;
    if (two_friction_directions_) impulse += point.m_lateralFrictionDir2 * point.m_appliedImpulseLateral2;
    const Side a{wrapper_a->getCollisionObject(), point.getPositionWorldOnA(), normal, impulse, index_a};
    const Side b{wrapper_b->getCollisionObject(), point.getPositionWorldOnB(), -normal, -impulse, index_b};
    addSide(a, b, point.m_appliedImpulse);
    addSide(b, a, point.m_appliedImpulse);
    return 0;
}

void ContactCollector::addSide(const Side& own, const Side& other, btScalar normal_impulse) {
    Breakable* breakable = breakables_.find(own.object);
    if (!breakable || !listens(*breakable)) return;
    StruckBreakable& entry = entryOf(*breakable);
    entry.blow.contacts.push_back(contactOn(*breakable, own, other));
    if (normal_impulse > entry.impulse_n_s) {
        entry.impulse_n_s = normal_impulse;
        entry.position = fromBullet(own.point);
        entry.normal = fromBullet(own.push);
    }
}

StruckBreakable& ContactCollector::entryOf(Breakable& breakable) {
    const auto [place, is_new] = place_in_struck_.try_emplace(&breakable, struck_.size());
    if (is_new) {
        const BodyState* state = before_.find(breakable.body);
        struck_.emplace_back().breakable = &breakable;
        struck_.back().before = state ? *state : stateOf(*breakable.body);
    }
    return struck_[place->second];
}

bool ContactCollector::listens(const Breakable& breakable) const {
    return breakable.canBeStruck() && (!breakable.isDynamic() || breakable.body->isActive()) &&
           breakable.breaksAt(time_s_);
}

ContactImpulse ContactCollector::contactOn(const Breakable& breakable, const Side& own,
                                           const Side& other) const {
    const BodyState* state = before_.find(own.object);
    const btTransform& stood = state ? state->transform : own.object->getWorldTransform();
    const btTransform asset_from_world = breakable.placed(stood).inverse();
    const PointMotion self = motionAt(*own.object, before_, own.point, own.push);
    const PointMotion partner = motionAt(*other.object, before_, other.point, own.push);

    ContactImpulse contact;
    contact.point = fromBullet(asset_from_world * own.point);
    contact.normal = fromBullet(asset_from_world.getBasis() * own.push);
    contact.impulse = fromBullet(asset_from_world.getBasis() * own.impulse);
    const double approach = (partner.before - self.before).dot(own.push);
    const double fall = time_step_s_ * (self.free_acceleration + partner.free_acceleration);
    contact.approach_m_s = approach > resting_steps * fall ? approach : std::min(approach, 0.0);
    contact.closing_after_m_s = (partner.after - self.after).dot(own.push);
    contact.effective_mass_kg = 1 / (self.inverse_mass + partner.inverse_mass);
    contact.partner_radius_m = strikingRadius(*other.object->getCollisionShape(), other.child);
    if (const Breakable* other_breakable = breakables_.find(other.object)) {
        contact.partner_youngs_modulus_pa = other_breakable->asset.material().youngs_modulus_pa;
        contact.partner_poisson_ratio = other_breakable->asset.material().poisson_ratio;
    }
    return contact;
}

std::vector<StruckBreakable> ContactCollector::takeStruck() {
    std::sort(struck_.begin(), struck_.end(), [](const StruckBreakable& a, const StruckBreakable& b) {
        return a.breakable->serial < b.breakable->serial;
    });
    place_in_struck_.clear();
    return std::move(struck_);
}

void feedSolvedContacts(btDiscreteDynamicsWorld& world, ContactCollector& collector) {
    btDispatcher& dispatcher = *world.getDispatcher();
    const auto& predictive = WorldInternals::predictiveManifolds(world);
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
        if (!a->isActive() && !b->isActive()) continue;
        if (!dispatcher.needsResponse(a, b)) continue;
        const bool foreseen = predictive.findLinearSearch(&manifold) != predictive.size();
        feedManifold(manifold, foreseen, collector);
    }
}

}  // namespace sherd
