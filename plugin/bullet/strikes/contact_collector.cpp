#include "bullet/strikes/contact_collector.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bullet/fragments/birth_overlaps.h"
#include "bullet/island/contact_motion.h"
#include "bullet/shapes/shapes.h"
#include "bullet/strikes/met_on_the_way.h"
#include "bullet/strikes/piles.h"
#include "bullet/strikes/same_blow.h"
#include "bullet/strikes/torn_out.h"
#include "bullet/world/conversions.h"
#include "core/loads/strike.h"

namespace sherd {

namespace {

/// Sets where the body was struck, and by what.
void tellWhere(StruckBreakable& struck) {
    const std::vector<ContactImpulse>& contacts = struck.blow.contacts;
    const ContactImpulse* foremost = leadingTouch(struck.blow, struck.breakable->asset.solid()->mass());
    if (!foremost)
        foremost = &*std::max_element(
            contacts.begin(), contacts.end(),
            [](const ContactImpulse& a, const ContactImpulse& b) { return a.pushed() < b.pushed(); });
    const btTransform from_asset = struck.breakable->placed(struck.before.transform);
    struck.position = fromBullet(from_asset * toBullet(foremost->point));
    struck.normal = struck.pushes[foremost - contacts.data()];
    struck.striker = struck.partners[foremost->partner];
}

}  // namespace

ContactCollector::ContactCollector(const BreakableRegistry& breakables, const StepSnapshot& before,
                                   double time_s, const btContactSolverInfo& info,
                                   const BirthOverlaps* overlaps, RecentStrikes* recent)
    : breakables_(breakables),
      before_(before),
      overlaps_(overlaps),
      time_s_(time_s),
      time_step_s_(info.m_timeStep),
      two_friction_directions_((info.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS) != 0),
      possible_(breakables, before, info.m_timeStep),
      recent_(recent) {}

btScalar ContactCollector::addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* wrapper_a,
                                           int, int index_a, const btCollisionObjectWrapper* wrapper_b, int,
                                           int index_b) {
    // A point that overlaps and carries nothing matters where a strike comes by it: others, met later and
    // further down, may have stopped the body.
    if (point.m_appliedImpulse <= 0 && point.getDistance() > 0) return 0;
    const btVector3 normal = point.m_normalWorldOnB;
    btVector3 impulse =
        normal * point.m_appliedImpulse + point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1;
    if (two_friction_directions_) impulse += point.m_lateralFrictionDir2 * point.m_appliedImpulseLateral2;
    lookUp(*wrapper_a->getCollisionObject(), party_a_);
    lookUp(*wrapper_b->getCollisionObject(), party_b_);
    const Side a{&party_a_, point.getPositionWorldOnA(),          normal, impulse,
                 index_a,   faces_.of_a ? &*faces_.of_a : nullptr};
    const Side b{&party_b_, point.getPositionWorldOnB(),          -normal, -impulse,
                 index_b,   faces_.of_b ? &*faces_.of_b : nullptr};
    addSide(a, b, point);
    addSide(b, a, point);
    return 0;
}

void ContactCollector::lookUp(const btCollisionObject& object, Party& party) const {
    if (party.object == &object) return;
    party.object = &object;
    party.before = before_.find(&object);
    party.breakable = breakables_.of(object);
    party.listens = party.breakable && listens(*party.breakable);
    if (party.listens) party.asset_from_world = party.breakable->placed(stoodAt(object)).inverse();
}

void ContactCollector::addSide(Side own, Side other, btManifoldPoint point) {
    if (!own.party->listens || isExempt(own, other)) return;
    correctTouch(own, other, point);
    Breakable& breakable = *own.party->breakable;
    ContactImpulse contact = contactOn(own, other, point);
    const bool rests = contact.supports() && point.getDistance() <= largestRestingGap();
    if (!contact.strikes() && !rests) return;
    const btCollisionObject& partner = *other.party->object;
    const bool is_out_of_reach =
        contact.strikes() && piles_ &&
        piles_->isStoppedBefore(partner, other.point, -own.push, contact.touched_s, contact.approach_m_s);
    if (is_out_of_reach) return;
    StruckBreakable& entry = entryOf(breakable, own.party->asset_from_world);
    contact.partner = entry.numberOf(&partner);
    if (contact.partner == static_cast<int>(entry.blow.partners.size())) {
        const btTransform& asset_from_world = own.party->asset_from_world;
        Mobility mobility = mobilityOf(partner, asset_from_world, own.point);
        // Where the two points were one. Deep in the body, its centre would have other levers.
        mobility.centre += contact.point - fromBullet(asset_from_world * other.point);
        const btVector3 pushed_out = partner.getWorldTransform().getOrigin() - stoodAt(partner).getOrigin();
        mobility.centre -= fromBullet(asset_from_world.getBasis() * pushed_out);  // by the solve
        entry.blow.partners.push_back(mobility);
    }
    entry.blow.contacts.push_back(contact);
    entry.pushes.push_back(fromBullet(own.push));
}

/// Whether the contact belongs to the blow that made the piece.
bool ContactCollector::isExempt(const Side& own, const Side& other) const {
    const Breakable *piece = own.party->breakable, *striker = other.party->breakable;
    return !goesOnThrough(*piece, *other.party->object, striker, time_s_) &&
           isOfTheSameBlow(*piece, *other.party->object, striker, time_s_);
}

bool ContactCollector::mayStrike(const btPersistentManifold& manifold) const {
    const BodyState *a = before_.find(manifold.getBody0()), *b = before_.find(manifold.getBody1());
    if (!a || !b) return true;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const btVector3& place = point.m_positionWorldOnB;
        const btVector3 meeting = b->velocityAt(place) - a->velocityAt(place);
        if (meeting.dot(point.m_normalWorldOnB) > slowest_landing_m_s) return true;
    }
    return false;
}

bool ContactCollector::wouldMeet(const btCollisionObject& a, const btCollisionObject& b,
                                 const btManifoldPoint& point) const {
    const btVector3& normal = point.m_normalWorldOnB;
    const PointMotion of_a = motionAt(a, before_.find(&a), point.m_positionWorldOnA, normal, time_step_s_);
    const PointMotion of_b = motionAt(b, before_.find(&b), point.m_positionWorldOnB, normal, time_step_s_);
    return (of_b.velocity - of_a.velocity).dot(normal) * btScalar(time_step_s_) > point.getDistance();
}

btScalar ContactCollector::shapeTolerance(const btCollisionObject& object) const {
    const Breakable* breakable = breakables_.of(object);
    const bool is_hulls = breakable && breakable->ownedHere() && !breakable->owned.shape->disjoint &&
                          object.getCollisionShape()->getShapeType() != BOX_SHAPE_PROXYTYPE;
    return is_hulls ? static_cast<btScalar>(shape_tolerance * breakable->asset.solid()->spacing()) : 0;
}

LandingBody ContactCollector::landing(const btCollisionObject& object) const {
    const Breakable* breakable = breakables_.of(object);
    if (!breakable || !breakable->ownedHere()) return {};
    const OwnedShape& owned = *breakable->owned.shape;
    if (owned.outermost.empty() || owned.shape.get() != object.getCollisionShape() || isScaled(*owned.shape))
        return {};
    const btTransform& stood = stoodAt(object);
    return {&owned.outermost,
            {owned.shape.get(), stood},
            stood * breakable->inner_ball.centre,
            btScalar(breakable->asset.solid()->spacing())};
}

const btTransform& ContactCollector::stoodAt(const btCollisionObject& object) const {
    const BodyState* state = before_.find(&object);
    return state ? state->transform : object.getWorldTransform();
}

int StruckBreakable::numberOf(const btCollisionObject* partner) {
    const auto known = std::find(partners.begin(), partners.end(), partner);
    const auto number = known - partners.begin();
    if (known == partners.end()) partners.push_back(partner);
    return static_cast<int>(number);
}

StruckBreakable& ContactCollector::entryOf(Breakable& breakable, const btTransform& asset_from_world) {
    const auto [place, is_new] = place_in_struck_.try_emplace(&breakable, struck_.size());
    if (is_new) {
        const BodyState* state = before_.find(breakable.body);
        struck_.emplace_back().breakable = &breakable;
        struck_.back().before = state ? *state : stateOf(*breakable.body);
        struck_.back().blow.free_turns = freeTurns(*breakable.body, asset_from_world);
    }
    return struck_[place->second];
}

std::unique_ptr<btPersistentManifold> ContactCollector::corrected(
    const btPersistentManifold& manifold) const {
    const bool is_any = breakables_.of(*manifold.getBody0()) || breakables_.of(*manifold.getBody1());
    return is_any ? metOnTheWay(manifold, before_, time_step_s_) : nullptr;
}

void ContactCollector::expect(const btPersistentManifold& manifold) {
    possible_.add(manifold);
}

void ContactCollector::lookForPiles(const std::vector<const btPersistentManifold*>& solved,
                                    const std::vector<const btPersistentManifold*>& predictive) {
    piles_ = std::make_shared<const Piles>(solved, predictive, breakables_, before_, time_s_, time_step_s_);
}

bool ContactCollector::isOfWhole(const btPersistentManifold& manifold) const {
    const auto isWhole = [&](const btCollisionObject& object) {
        const Breakable* breakable = breakables_.of(object);
        return breakable && !breakable->isFragment();
    };
    return isWhole(*manifold.getBody0()) || isWhole(*manifold.getBody1());
}

bool ContactCollector::listensTo(const btPersistentManifold& manifold) const {
    for (const btCollisionObject* object : {manifold.getBody0(), manifold.getBody1()}) {
        const Breakable* breakable = breakables_.of(*object);
        if (breakable && listens(*breakable)) return true;
    }
    return false;
}

bool ContactCollector::listens(const Breakable& breakable) const {
    const bool may_break = possible_.mayBreak(breakable) || (piles_ && piles_->mayBreak(breakable));
    return may_break && breakable.canBeStruck() && (!breakable.isDynamic() || breakable.body->isActive()) &&
           (breakable.isHeldRest() || breakable.breaksAt(time_s_));
}

std::vector<StruckBreakable> ContactCollector::takeStruck() {
    if (piles_)
        for (StruckBreakable& struck : struck_) piles_->attachTo(struck);
    for (StruckBreakable& struck : struck_) tellWhere(struck);
    std::sort(struck_.begin(), struck_.end(), [](const StruckBreakable& a, const StruckBreakable& b) {
        return a.breakable->serial < b.breakable->serial;
    });
    place_in_struck_.clear();
    return std::move(struck_);
}

}  // namespace sherd
