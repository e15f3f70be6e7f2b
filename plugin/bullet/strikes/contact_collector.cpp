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
#include "core/loads/first_touch.h"
#include "core/loads/strike.h"

namespace sherd {

namespace {

constexpr btScalar slowest_landing_m_s = btScalar(0.1);  // below it, what Bullet gives is taken

/// How fast what rests on a body comes onto it when that lands: at rest, or on its way back, it lies in the
/// way of what still moves as before. 0 or less if it does not.
double speedOnto(const btCollisionObject& landed, const btVector3& point, const btVector3& push,
                 const PointMotion& self, double time_step_s) {
    const PointMotion after = motionAt(landed, nullptr, point, push, time_step_s);
    const double closing = (after.velocity - self.velocity).dot(push);
    return closing > slowestStrike(self, after, time_step_s) ? closing : std::min(closing, 0.0);
}

/// A ball touches with one point after the other, all of them around its centre.
PointMotion centreOfBall(PointMotion surface, const btVector3& to_centre) {
    surface.arm += to_centre;
    return surface;
}

btMatrix3x3 turnBy(const btVector3& angles) {
    const btScalar angle = angles.length();
    return angle > 0 ? btMatrix3x3(btQuaternion(angles / angle, angle)) : btMatrix3x3::getIdentity();
}

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
                                   const BirthOverlaps* overlaps)
    : breakables_(breakables),
      before_(before),
      overlaps_(overlaps),
      time_s_(time_s),
      time_step_s_(info.m_timeStep),
      two_friction_directions_((info.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS) != 0),
      possible_(breakables, before, info.m_timeStep) {}

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
    const Side a{&party_a_, point.getPositionWorldOnA(), normal, impulse, index_a};
    const Side b{&party_b_, point.getPositionWorldOnB(), -normal, -impulse, index_b};
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

/// Where and when a ball met the true surface, if the hulls that stand for that say otherwise: deep in one of
/// them it comes out at its side.
void ContactCollector::correctTouch(Side& own, Side& other, btManifoldPoint& point) const {
    const btCollisionObject& striker = *other.party->object;
    const auto radius = btScalar(ballRadius(*striker.getCollisionShape(), other.child));
    if (!(radius > 0)) return;
    const bool is_one = striker.getCollisionShape()->getShapeType() == SPHERE_SHAPE_PROXYTYPE;
    const btVector3 centre = is_one ? stoodAt(striker).getOrigin() : other.point - radius * own.push;
    const btVector3 meeting =
        motionAt(striker, other.party->before, centre, own.push, time_step_s_).velocity -
        motionAt(*own.party->object, own.party->before, own.point, own.push, time_step_s_).velocity;
    const btScalar closing = meeting.dot(own.push);
    if (!(closing > slowest_landing_m_s)) return;
    const btTransform& asset_from_world = own.party->asset_from_world;
    const FirstTouch known{fromBullet(asset_from_world * own.point),
                           fromBullet(asset_from_world.getBasis() * own.push),
                           timeSinceTouch(closing, -point.getDistance(), time_step_s_)};
    const auto touch = trueTouch(own.party->breakable->asset.solid()->surfaceTree(),
                                 {fromBullet(asset_from_world * centre),
                                  fromBullet(asset_from_world.getBasis() * meeting), double(radius)},
                                 known, time_step_s_);
    if (!touch) return;
    const btVector3 push = asset_from_world.getBasis().transpose() * toBullet(touch->push);
    const btScalar pressed = own.impulse.dot(own.push);
    const btVector3 along = own.impulse - pressed * own.push;
    own.impulse = pressed * push + along - along.dot(push) * push;
    other.impulse = -own.impulse;
    own.push = push;
    other.push = -push;
    own.point = asset_from_world.inverse() * toBullet(touch->point);
    other.point = centre + radius * push;
    point.setDistance(btScalar(-touch->ago_s) * meeting.dot(push));
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

/// Whether two whole bodies that were put into each other move there a little: their hulls meet, which their
/// surfaces need not.
bool ContactCollector::rubInEachOther(const Side& own, const Side& other, double closing_m_s) const {
    constexpr double slow_m_s = 0.25;
    const Breakable *a = own.party->breakable, *b = other.party->breakable;
    return overlaps_ && closing_m_s < slow_m_s && !(a && a->isFragment()) && !(b && b->isFragment()) &&
           overlaps_->allows(*own.party->object, *other.party->object);
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

/// Where on a body something round touched it, which has slid along it since, as far as the points do not
/// tell: those of predictive contacts do.
btVector3 ContactCollector::placeOfTouch(const Side& own, const Side& other, btScalar radius,
                                         const btVector3& velocity, double touched_s) const {
    const btVector3 centre = other.point - radius * own.push;
    const PointMotion round =
        motionAt(*other.party->object, other.party->before, centre, own.push, time_step_s_);
    const btVector3 way = btScalar(touched_s) * (round.velocity - velocity);
    const btVector3 slid = way - (other.point - own.point);
    return own.point - (slid - own.push * slid.dot(own.push));
}

/// Where one side of a contact touches, if that is a whole body: of pieces there are many, and to find one's
/// way about their surfaces takes longer than a blow by them is worth.
std::shared_ptr<const TouchingSurface> ContactCollector::surfaceAt(const Side& own,
                                                                   const btVector3& push) const {
    const Breakable& breakable = *own.party->breakable;
    if (breakable.isFragment()) return nullptr;
    const std::shared_ptr<const BreakableSolid> solid = breakable.asset.solid();
    const btTransform asset_from_world = breakable.placed(stoodAt(*own.party->object)).inverse();
    auto surface = std::make_shared<TouchingSurface>();
    surface->surface = {solid, &solid->surfaceTree()};
    surface->point = fromBullet(asset_from_world * own.point);
    surface->push = fromBullet(asset_from_world.getBasis() * push);
    surface->wall_thickness_m = solid->wallThickness();
    return surface;
}

ContactImpulse ContactCollector::contactOn(const Side& own, const Side& other,
                                           const btManifoldPoint& point) const {
    const btTransform& asset_from_world = own.party->asset_from_world;
    const btCollisionObject& striker = *other.party->object;
    const auto radius = btScalar(strikingRadius(*striker.getCollisionShape(), other.child));
    const PointMotion self =
        motionAt(*own.party->object, own.party->before, own.point, own.push, time_step_s_);
    const PointMotion partner = motionAt(striker, other.party->before, other.point, own.push, time_step_s_);
    const btVector3 meeting = partner.velocity - self.velocity;
    const double closing = meeting.dot(own.push), depth_m = -point.getDistance();
    const auto own_ball = btScalar(ballRadius(*own.party->object->getCollisionShape(), own.child)),
               ball = btScalar(ballRadius(*striker.getCollisionShape(), other.child));
    const TouchOfPoints touch =
        touchOf(centreOfBall(self, own_ball * own.push), centreOfBall(partner, -ball * own.push), own.push,
                depth_m, time_step_s_);
    // What the app pushes strikes as what flies freely does: only gravity makes bodies at rest seem to close.
    const double slowest = slowestStrike(self, partner, time_step_s_);
    const bool strikes = closing > slowest && !(touch.is_bent && touch.speed_m_s <= slowest) &&
                         !rubInEachOther(own, other, closing);
    // A vertex touched the ground as the body was turned then; a ball touches wherever it is lowest.
    const bool is_turned = strikes && &striker == ground_ && !(own_ball > 0);
    const btMatrix3x3 basis = is_turned
                                  ? asset_from_world.getBasis() * turnBy(self.spin * btScalar(touch.ago_s))
                                  : asset_from_world.getBasis();

    ContactImpulse contact;
    contact.normal = fromBullet(basis * own.push);
    contact.impulse = fromBullet(basis * own.impulse);
    contact.approach_m_s = strikes ? touch.speed_m_s : std::min(closing, 0.0);
    if (!contact.strikes() && depth_m >= -largestRestingGap() && piles_ && piles_->lands(striker))
        contact.approach_m_s = speedOnto(striker, other.point, own.push, self, time_step_s_);
    contact.touched_s = touch.ago_s;
    const btVector3 touched = contact.strikes() && radius > 0
                                  ? placeOfTouch(own, other, radius, self.velocity, contact.touched_s)
                                  : own.point;
    contact.point = fromBullet(asset_from_world * touched);
    contact.slip_m_s = fromBullet(basis * (meeting - own.push * btScalar(closing)));
    contact.friction = point.m_combinedFriction;
    contact.partner_radius_m = static_cast<double>(radius);
    if (const Breakable* other_breakable = other.party->breakable) {
        contact.partner_youngs_modulus_pa = other_breakable->asset.material().youngs_modulus_pa;
        contact.partner_poisson_ratio = other_breakable->asset.material().poisson_ratio;
        if (contact.strikes() && !(radius > 0)) contact.partner_surface = surfaceAt(other, -own.push);
    }
    return contact;
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
