// A pile as the loads of one of its bodies see it.

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bullet/island/contact_motion.h"
#include "bullet/shapes/shapes.h"
#include "bullet/strikes/piles.h"
#include "bullet/world/conversions.h"
#include "core/loads/footprint.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double margin_of_contact = 0.05;  // of the smaller body's smallest extent: what a corner touches

/// Youngs' modulus and Poisson's ratio.
std::pair<double, double> elasticityOf(const Breakable* breakable, const ContactSettings& settings) {
    if (!breakable) return {settings.partner_youngs_modulus_pa, settings.partner_poisson_ratio};
    const Material& material = breakable->asset.material();
    return {material.youngs_modulus_pa, material.poisson_ratio};
}

}  // namespace

Stack Piles::stackOf(const Pile& pile, StruckBreakable& struck) const {
    const btCollisionObject* own = struck.breakable->body;
    const btTransform from_world = struck.breakable->placed(struck.before.transform).inverse();
    Stack stack;
    for (const btCollisionObject* object : pile.bodies)
        if (object != own) stack.bodies.push_back(stackBody(*object, pile, struck, from_world));
    for (const btPersistentManifold* manifold : pile.contacts)
        if (manifold->getBody0() != own && manifold->getBody1() != own)
            addContacts(*manifold, struck, from_world, stack);
    if (pile.strike.struck != own) stack.strike = distantStrike(pile.strike, struck, from_world);
    return stack;
}

StackBody Piles::stackBody(const btCollisionObject& object, const Pile& pile, StruckBreakable& struck,
                           const btTransform& from_world) const {
    const Breakable* breakable = breakables_.of(object);
    const btVector3 extent = extentOf(object);
    const btVector3 along = (pile.strike.push * object.getWorldTransform().getBasis()).absolute();
    const double length = along.dot(extent);
    const double volume =
        breakable ? breakable->asset.solid()->moments().volume : double(extent.x()) * extent.y() * extent.z();
    const double modulus = elasticityOf(breakable, struck.breakable->fracture->contact).first;
    return {struck.numberOf(&object), mobilityOf(object, from_world, pile.strike.point),
            length * length / (modulus * volume)};
}

void Piles::addContacts(const btPersistentManifold& manifold, StruckBreakable& struck,
                        const btTransform& from_world, Stack& stack) const {
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    const auto numberIn = [&](const btCollisionObject* object) {
        return givesWay(*object) && stack.body(struck.numberOf(object)) ? struck.numberOf(object) : -1;
    };
    std::vector<StackContact> contacts;
    std::vector<Vec3> points;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        if (point.getDistance() > largestRestingGap()) continue;
        points.push_back(fromBullet(from_world * point.getPositionWorldOnA()));
        contacts.push_back({numberIn(a), numberIn(b), points.back(),
                            fromBullet(from_world.getBasis() * point.m_normalWorldOnB), 0});
    }
    if (contacts.empty()) return;
    const btVector3 of_a = extentOf(*a), of_b = extentOf(*b);
    const double smallest = std::min(of_a[of_a.minAxis()], of_b[of_b.minAxis()]);
    const double area = Footprint(points, contacts.front().push, margin_of_contact * smallest).area();
    const double modulus = contactBetween(*a, *b, struck.breakable->fracture->contact).contact_modulus_pa;
    for (StackContact& contact : contacts) {
        contact.stiffness_n_m = 2 * modulus * std::sqrt(area / pi) / static_cast<double>(contacts.size());
        stack.contacts.push_back(contact);
    }
}

DistantStrike Piles::distantStrike(const Strike& strike, StruckBreakable& struck,
                                   const btTransform& from_world) const {
    DistantStrike distant;
    distant.number = struck.numberOf(strike.struck);
    distant.point = fromBullet(from_world * strike.point);
    distant.push = fromBullet(from_world.getBasis() * strike.push);
    distant.speed_m_s = strike.speed_m_s;
    const Mobility striker = mobilityOf(*strike.striker, from_world, strike.point);
    distant.striker_mobility = distant.push.dot(striker.at(distant.point) * distant.push);
    const ContactSettings& settings = struck.breakable->fracture->contact;
    distant.hertz = contactBetween(*strike.struck, *strike.striker, settings);
    const double own = strikingRadius(*strike.struck->getCollisionShape(), strike.struck_child),
                 other = strikingRadius(*strike.striker->getCollisionShape(), strike.striker_child);
    const double curvature = (own > 0 ? 1 / own : 0) + (other > 0 ? 1 / other : 0);
    const Breakable* breakable = breakables_.of(*strike.struck);
    const btVector3 extent = extentOf(*strike.struck);
    const double wall = breakable ? breakable->asset.solid()->wallThickness() : extent[extent.minAxis()];
    const double least = settings.smallest_patch * wall;
    const double most =
        std::max(least, breakable ? breakable->asset.solid()->boundingRadius() : double(extent.length()) / 2);
    distant.hertz.radius_m = std::clamp(curvature > 0 ? 1 / curvature : most, least, most);
    return distant;
}

/// Its modulus.
HertzContact Piles::contactBetween(const btCollisionObject& a, const btCollisionObject& b,
                                   const ContactSettings& settings) const {
    const auto of_a = elasticityOf(breakables_.of(a), settings),
               of_b = elasticityOf(breakables_.of(b), settings);
    return {0, contactModulus(of_a.first, of_a.second, of_b.first, of_b.second)};
}

}  // namespace sherd
