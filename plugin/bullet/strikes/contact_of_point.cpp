// What one solved point is to the body that it pushes: where, when and how fast the two met.

#include <algorithm>
#include <memory>

#include "bullet/fragments/birth_overlaps.h"
#include "bullet/island/contact_motion.h"
#include "bullet/shapes/shapes.h"
#include "bullet/strikes/contact_collector.h"
#include "bullet/strikes/piles.h"
#include "bullet/strikes/recent_strikes.h"
#include "bullet/world/conversions.h"
#include "core/loads/first_touch.h"

namespace sherd {

namespace {

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

}  // namespace

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

/// Whether two whole bodies that were put into each other move there a little: their hulls meet, which their
/// surfaces need not.
bool ContactCollector::rubInEachOther(const Side& own, const Side& other, double closing_m_s) const {
    constexpr double slow_m_s = 0.25;
    const Breakable *a = own.party->breakable, *b = other.party->breakable;
    return overlaps_ && closing_m_s < slow_m_s && !(a && a->isFragment()) && !(b && b->isFragment()) &&
           overlaps_->allows(*own.party->object, *other.party->object);
}

/// Whether what closes there is what the steps before have left of a strike that they have counted.
bool ContactCollector::isLeftOver(const Side& own, const Side& other, double closing_m_s,
                                  double slowest_m_s) const {
    return recent_ && !own.party->breakable->isFragment() &&
           recent_->goOnWith({own.party->object, other.party->object, own.point, own.push,
                              fromBullet(own.party->asset_from_world * own.point)},
                             closing_m_s, slowest_m_s, time_s_, time_step_s_);
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
    // Of a cylinder that touches with its end, none.
    const auto radius = btScalar(other.face ? 0 : strikingRadius(*striker.getCollisionShape(), other.child));
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
    const bool is_quick = closing > slowest && !(touch.is_bent && touch.speed_m_s <= slowest);
    const bool is_set_down = !own.party->breakable->isFragment() &&
                             isSetDown(striker, *own.party->object, closing, depth_m, slowest, time_step_s_);
    const bool meets = (is_quick || is_set_down) && !rubInEachOther(own, other, closing);
    const bool is_left_over = meets && isLeftOver(own, other, closing, slowest);
    const bool strikes = meets && !is_left_over;
    // A vertex touched the ground as the body was turned then; a ball touches wherever it is lowest.
    const bool is_turned = strikes && other.face && striker.isStaticObject() && !(own_ball > 0);
    const btMatrix3x3 basis = is_turned
                                  ? asset_from_world.getBasis() * turnBy(self.spin * btScalar(touch.ago_s))
                                  : asset_from_world.getBasis();

    ContactImpulse contact;
    contact.normal = fromBullet(basis * own.push);
    contact.impulse = fromBullet(basis * own.impulse);
    contact.approach_m_s = strikes ? touch.speed_m_s : std::min(closing, 0.0);
    if (!meets && depth_m >= -largestRestingGap() && piles_ && piles_->lands(striker))
        contact.approach_m_s = speedOnto(striker, other.point, own.push, self, time_step_s_);
    contact.touched_s = touch.ago_s;
    const btVector3 touched = contact.strikes() && radius > 0
                                  ? placeOfTouch(own, other, radius, self.velocity, contact.touched_s)
                                  : own.point;
    contact.point = fromBullet(asset_from_world * touched);
    contact.slip_m_s = fromBullet(basis * (meeting - own.push * btScalar(closing)));
    contact.friction = point.m_combinedFriction;
    contact.partner_radius_m = static_cast<double>(radius);
    contact.partner_is_ground = striker.isStaticObject();
    contact.partner_is_flat = other.face && own.party->breakable->isDynamic();
    if (contact.partner_is_flat) contact.partner_reach_m = other.face->roomAround(other.point);
    if (const Breakable* other_breakable = other.party->breakable) {
        contact.partner_youngs_modulus_pa = other_breakable->asset.material().youngs_modulus_pa;
        contact.partner_poisson_ratio = other_breakable->asset.material().poisson_ratio;
        if (contact.strikes() && !(radius > 0)) contact.partner_surface = surfaceAt(other, -own.push);
    }
    return contact;
}

}  // namespace sherd
