#include "bullet/foresight.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "bullet/contact_motion.h"
#include "bullet/conversions.h"
#include "bullet/extra_contacts.h"
#include "bullet/world_internals.h"

namespace sherd {

namespace {

constexpr double rounding_s = 1e-9;  // of the simulated time
constexpr int most_surprises = 3;
constexpr double rest_after_surprises_s = 0.25;
constexpr btScalar off_the_way_m = btScalar(5e-4);
constexpr btScalar off_the_speed = btScalar(0.01);  // relative, and of a metre or a radian a second
constexpr std::size_t most_met = 4, most_roles = 16;
constexpr double light = 0.02;  // of a body's mass: what supports it does more
constexpr double heavy = 0.25;  // of its mass: what touches it turns it aside

bool isOnItsWay(const btRigidBody& body, const BodyState& foreseen) {
    const btScalar off = (body.getWorldTransform().getOrigin() - foreseen.transform.getOrigin()).length();
    const btScalar faster = (body.getLinearVelocity() - foreseen.linear).length();
    const btScalar turn = (body.getAngularVelocity() - foreseen.angular).length();
    return off <= off_the_way_m && faster <= off_the_speed * (1 + foreseen.linear.length()) &&
           turn <= off_the_speed * (1 + foreseen.angular.length());
}

/// What a contact may differ by from the foreseen one, in parts of the particle spacing and of the speed: far
/// less than the stress is exact to.
constexpr double same_place = 0.1, same_speed = 0.01, same_direction = 1e-3;

bool isSame(const ContactImpulse& a, const ContactImpulse& b, double spacing) {
    if (!b.strikes() || a.partner_radius_m != b.partner_radius_m) return false;
    if ((a.point - b.point).norm() > same_place * spacing) return false;
    if ((a.normal - b.normal).squaredNorm() > same_direction) return false;
    const double speed = a.approach_m_s;
    return std::abs(speed - b.approach_m_s) <= same_speed * speed &&
           (a.slip_m_s - b.slip_m_s).norm() <= same_speed * (speed + a.slip_m_s.norm()) &&
           std::abs(a.touched_s - b.touched_s) * speed <= same_place * spacing;
}

using Partners = std::vector<const btCollisionObject*>;

/// Whether each strike of `a` is one of `b`.
bool hasStrikesOf(const Blow& a, const Partners& partners_a, const Blow& b, const Partners& partners_b,
                  double spacing) {
    return std::all_of(a.contacts.begin(), a.contacts.end(), [&](const ContactImpulse& contact) {
        return !contact.strikes() ||
               std::any_of(b.contacts.begin(), b.contacts.end(), [&](const ContactImpulse& other) {
                   return partners_a[contact.partner] == partners_b[other.partner] &&
                          isSame(contact, other, spacing);
               });
    });
}

/// What a body rests on or leans against, but for what is light. Which points it touches that with depends on
/// the step.
Partners supportsOf(const Blow& blow, const Partners& partners, double mass_kg) {
    Partners supports;
    for (int number = 0; number < static_cast<int>(partners.size()); ++number)
        if (!blow.isStruckBy(number) && !(light * mass_kg * blow.partner(number).inverse_mass > 1))
            supports.push_back(partners[number]);
    std::sort(supports.begin(), supports.end());
    return supports;
}

bool areSame(const Blow& a, const Partners& partners_a, const Blow& b, const Partners& partners_b,
             const BreakableSolid& solid) {
    const double spacing = solid.spacing();
    return hasStrikesOf(a, partners_a, b, partners_b, spacing) &&
           hasStrikesOf(b, partners_b, a, partners_a, spacing) &&
           supportsOf(a, partners_a, solid.mass()) == supportsOf(b, partners_b, solid.mass());
}

bool areSame(const Stack& a, const Stack& b) {
    return a.bodies.size() == b.bodies.size() && a.contacts.size() == b.contacts.size() &&
           a.strike.strikes() == b.strike.strikes() &&
           std::abs(a.strike.speed_m_s - b.strike.speed_m_s) <= same_speed * a.strike.speed_m_s;
}

bool isSameQuestion(const BlowToDecide& a, const BlowToDecide& b) {
    return a.solid == b.solid && a.seed == b.seed && a.earlier == b.earlier &&
           a.fracture->largest_fragment_count == b.fracture->largest_fragment_count &&
           a.fracture->fragment_count == b.fracture->fragment_count;
}

/// What the world's broadphase finds in a box.
class Found final : public btBroadphaseAabbCallback {
  public:
    bool process(const btBroadphaseProxy* proxy) override {
        objects.push_back(static_cast<const btCollisionObject*>(proxy->m_clientObject));
        return true;
    }
    std::vector<const btCollisionObject*> objects;
};

bool meet(const btCollisionObject& a, const btCollisionObject& b) {
    const btBroadphaseProxy *of_a = a.getBroadphaseHandle(), *of_b = b.getBroadphaseHandle();
    return of_a && of_b && (of_a->m_collisionFilterGroup & of_b->m_collisionFilterMask) != 0 &&
           (of_b->m_collisionFilterGroup & of_a->m_collisionFilterMask) != 0;
}

/// Whether a stand-in does what the object does: of links of multi-bodies and soft bodies none would.
bool canStandIn(const btCollisionObject& object) {
    const bool is_rigid = btRigidBody::upcast(&object) != nullptr;
    return object.hasContactResponse() &&
           (is_rigid ||
            (object.getInternalType() == btCollisionObject::CO_COLLISION_OBJECT && object.isStaticObject()));
}

/// Where a body may be within some time, as a box.
void sweptBox(const btRigidBody& body, double ahead_s, btVector3& low, btVector3& high) {
    body.getAabb(low, high);
    const auto t = static_cast<btScalar>(ahead_s);
    const btVector3 way = body.getLinearVelocity() * t, fall = body.getGravity() * (t * t / 2);
    btVector3 furthest_low = low, furthest_high = high;
    for (const btVector3& shift : {way, btVector3(way + fall)}) {
        furthest_low.setMin(low + shift);
        furthest_high.setMax(high + shift);
    }
    low = furthest_low;
    high = furthest_high;
}

/// Whether a straight way, which the ball around a body goes, leads through the box of another one.
bool isOnTheWay(const btRigidBody& body, const btCollisionObject& other, double ahead_s) {
    btVector3 centre;
    btScalar radius;
    body.getCollisionShape()->getBoundingSphere(centre, radius);
    const btBroadphaseProxy& proxy = *other.getBroadphaseHandle();
    const btVector3 margin(radius, radius, radius), low = proxy.m_aabbMin - margin,
                                                    high = proxy.m_aabbMax + margin;
    const btVector3 from = body.getWorldTransform() * centre,
                    to = from + body.getLinearVelocity() * static_cast<btScalar>(ahead_s);
    btScalar part = 1;
    btVector3 normal;
    return TestPointAgainstAabb2(low, high, from) || btRayAabb(from, to, low, high, part, normal);
}

/// What a body brings to what stands still, J, and somewhat more: gravity goes on pulling.
double energyOf(const btRigidBody& mover) {
    btVector3 centre;
    btScalar radius;
    mover.getCollisionShape()->getBoundingSphere(centre, radius);
    const double speed =
        mover.getLinearVelocity().length() + (centre.length() + radius) * mover.getAngularVelocity().length();
    return speed * speed / mover.getInvMass();
}

/// What a body does by itself, from its last step; as gravity has it where something touches it.
Role roleOf(const btCollisionObject& object, const BreakableRegistry& breakables, const StepSnapshot& before,
            btScalar time_step_s, bool is_touched) {
    Role role;
    role.object = &object;
    role.breakable = breakables.of(object);
    const btRigidBody* body = btRigidBody::upcast(&object);
    const BodyState* state = body && canMove(*body) && !is_touched ? before.find(body) : nullptr;
    if (!state || !body->isActive()) return role;
    role.acceleration = (body->getLinearVelocity() - state->linear) / time_step_s;
    const btScalar off = (role.acceleration - body->getGravity()).length();
    role.is_driven = off > btScalar(0.01) * (1 + body->getGravity().length());
    return role;
}

}  // namespace

bool mayBring(const btRigidBody& mover, double energy_j) {
    return energyOf(mover) >= energy_j;
}

bool isForeseeable(const Breakable& breakable, double time_s) {
    return breakable.in_world && !breakable.isFragment() && breakable.asset.solid()->reducedStress() &&
           breakable.canBeStruck() && breakable.body->getNumConstraintRefs() == 0 &&
           breakable.breaksAt(time_s);
}

std::vector<Role> rolesAround(btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                              const StepSnapshot& before, btRigidBody& mover, double ahead_s, double time_s) {
    const double energy = energyOf(mover);
    const auto worthIt = [&](const btCollisionObject& other) {
        for (const btCollisionObject* struck : {&other, static_cast<const btCollisionObject*>(&mover)}) {
            const Breakable* breakable = breakables.of(*struck);
            if (breakable && isForeseeable(*breakable, time_s) && energy >= breakable->least_energy_j)
                return true;
        }
        return false;
    };
    btVector3 low, high;
    sweptBox(mover, ahead_s, low, high);
    Found found;
    world.getBroadphase()->aabbTest(low, high, found);
    std::vector<const btCollisionObject*> met;
    for (const btCollisionObject* object : found.objects)
        if (object != &mover && canStandIn(*object) && meet(mover, *object) &&
            isOnTheWay(mover, *object, ahead_s))
            met.push_back(object);
    if (std::none_of(met.begin(), met.end(), [&](const auto* other) { return worthIt(*other); })) return {};

    // The nearest, and of what is equally near, those that have been in the world longer.
    mover.getAabb(low, high);
    const auto distance = [&](const btCollisionObject* object) {
        const btBroadphaseProxy& proxy = *object->getBroadphaseHandle();
        btVector3 gap = proxy.m_aabbMin - high, other_gap = low - proxy.m_aabbMax;
        gap.setMax(other_gap);
        gap.setMax(btVector3(0, 0, 0));
        return gap.length2();
    };
    std::sort(met.begin(), met.end(), [&](const btCollisionObject* a, const btCollisionObject* b) {
        return std::make_pair(distance(a), a->getWorldArrayIndex()) <
               std::make_pair(distance(b), b->getWorldArrayIndex());
    });
    if (met.size() > most_met) met.resize(most_met);

    const auto turnsAside = [&](const btCollisionObject& other) {
        const btRigidBody* body = btRigidBody::upcast(&other);
        return !other.isStaticOrKinematicObject() && body && heavy * body->getInvMass() < mover.getInvMass();
    };
    std::unordered_set<const btCollisionObject*> cast(met.begin(), met.end()), touched;
    cast.insert(&mover);
    const std::unordered_set<const btCollisionObject*> first(cast);
    btDispatcher& dispatcher = *world.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() == 0) continue;
        const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
        const bool is_touched = a == &mover || b == &mover;
        if (is_touched && (breakables.of(mover) || turnsAside(a == &mover ? *b : *a))) return {};
        touched.insert({a, b});
        for (const auto& [own, other] : {std::make_pair(a, b), std::make_pair(b, a)}) {
            if (first.count(own) == 0 || own->isStaticObject() || cast.size() >= most_roles) continue;
            if (isInWorld(world, other) && canStandIn(*other)) cast.insert(other);
        }
    }
    std::vector<const btCollisionObject*> in_order(cast.begin(), cast.end());
    std::sort(in_order.begin(), in_order.end(), [](const btCollisionObject* a, const btCollisionObject* b) {
        return a->getWorldArrayIndex() < b->getWorldArrayIndex();
    });
    std::vector<Role> roles;
    for (const btCollisionObject* object : in_order)
        roles.push_back(
            roleOf(*object, breakables, before, world.getSolverInfo().m_timeStep, touched.count(object) > 0));
    return roles;
}

int Foresight::clear() {
    const auto count = static_cast<int>(blows_.size());
    outlooks_.clear();
    blows_.clear();
    return count;
}

Foresight::Outlook* Foresight::of(const btCollisionObject* mover) {
    const auto known = std::find_if(outlooks_.begin(), outlooks_.end(),
                                    [&](const Outlook& outlook) { return outlook.mover == mover; });
    return known == outlooks_.end() ? nullptr : &*known;
}

void Foresight::surprised(Outlook& outlook, double time_s) {
    if (++outlook.surprises < most_surprises) return;
    outlook.surprises = 0;
    outlook.rests_until_s = time_s + rest_after_surprises_s;
}

int Foresight::follow(const btDiscreteDynamicsWorld& world, double time_s) {
    std::vector<const btCollisionObject*> strayed;
    for (Outlook& outlook : outlooks_) {
        const btRigidBody* body =
            isInWorld(world, outlook.mover) ? btRigidBody::upcast(outlook.mover) : nullptr;
        const bool is_over = outlook.steps >= outlook.way.size();
        const bool is_right = body && !is_over && isOnItsWay(*body, outlook.way[outlook.steps]);
        ++outlook.steps;
        if (is_right) continue;
        outlook.way.clear();
        outlook.until_s = time_s;
        strayed.push_back(outlook.mover);
        if (!is_over) surprised(outlook, time_s);
    }
    int in_vain = 0;
    const auto past = [&](const ForeseenBlow& blow) {
        const bool has_strayed = std::find(strayed.begin(), strayed.end(), blow.mover) != strayed.end();
        if (!has_strayed && blow.strikes_at_s > time_s + rounding_s) return false;
        ++in_vain;
        return true;
    };
    blows_.erase(std::remove_if(blows_.begin(), blows_.end(), past), blows_.end());
    outlooks_.erase(std::remove_if(outlooks_.begin(), outlooks_.end(),
                                   [&](const Outlook& outlook) {
                                       return outlook.way.empty() && outlook.surprises == 0 &&
                                              outlook.rests_until_s <= time_s;
                                   }),
                    outlooks_.end());
    return in_vain;
}

bool Foresight::isToBeLookedAt(const btCollisionObject& mover, double time_s, double ahead_s) const {
    const auto known = std::find_if(outlooks_.begin(), outlooks_.end(),
                                    [&](const Outlook& outlook) { return outlook.mover == &mover; });
    if (known == outlooks_.end()) return true;
    const bool strikes = std::any_of(blows_.begin(), blows_.end(),
                                     [&](const ForeseenBlow& blow) { return blow.mover == &mover; });
    return !strikes && known->rests_until_s <= time_s && known->until_s < time_s + ahead_s;
}

void Foresight::note(const btCollisionObject& mover, std::vector<BodyState> way, double until_s) {
    Outlook* outlook = of(&mover);
    if (!outlook) {
        outlooks_.emplace_back();
        outlook = &outlooks_.back();
        outlook->mover = &mover;
    }
    outlook->way = std::move(way);
    outlook->steps = 0;
    outlook->until_s = until_s;
}

void Foresight::note(ForeseenBlow blow) {
    blows_.push_back(std::move(blow));
}

bool Foresight::isForeseen(std::uint64_t serial) const {
    return std::any_of(blows_.begin(), blows_.end(),
                       [&](const ForeseenBlow& blow) { return blow.serial == serial; });
}

std::shared_ptr<DecidedBlow> Foresight::take(const StruckBreakable& struck, const BlowToDecide& blow) {
    // A push of the app's own has no bodies for partners.
    if (static_cast<int>(struck.partners.size()) < blow.blow.partnerCount()) return nullptr;
    const auto known = std::find_if(blows_.begin(), blows_.end(), [&](const ForeseenBlow& foreseen) {
        return foreseen.serial == struck.breakable->serial;
    });
    if (known == blows_.end() || !isSameQuestion(known->blow, blow) ||
        !areSame(known->blow.blow, known->partners, blow.blow, struck.partners, *blow.solid) ||
        !areSame(known->blow.blow.stack, blow.blow.stack))
        return nullptr;
    std::shared_ptr<DecidedBlow> decided = std::move(known->decided);
    if (Outlook* outlook = of(known->mover)) {
        outlook->surprises = 0;
        outlook->way.clear();  // it goes on another way
        outlook->until_s = 0;
    }
    blows_.erase(known);
    return decided;
}

}  // namespace sherd
