#include "bullet/applied_blow.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bullet/body_checks.h"
#include "bullet/contact_motion.h"
#include "bullet/conversions.h"
#include "bullet/fragment_motion.h"
#include "core/loads/load_patch.h"

namespace sherd {

namespace {

template <class Value>
Status refused(const char* what, const Value& value, const char* wanted) {
    std::ostringstream sentence;
    sentence << "the " << what << " of the push is " << value << " but must be " << wanted;
    return Error{sentence.str()};
}

std::string words(const btVector3& v) {
    std::ostringstream text;
    text << "(" << v.x() << ", " << v.y() << ", " << v.z() << ")";
    return text.str();
}

bool isNotNegative(double value) {
    return std::isfinite(value) && value >= 0;
}

Status checkPush(const Push& push) {
    if (!isFinite(push.point)) return refused("point", words(push.point), "finite, in m");
    if (!isFinite(push.impulse_n_s) || !(push.impulse_n_s.length() > 0))
        return refused("impulse", words(push.impulse_n_s), "finite and not zero, in N s");
    if (!isNotNegative(push.patch_radius_m))
        return refused("patch radius", push.patch_radius_m,
                       "0 (as small as the settings allow) or positive, in m");
    if (!isNotNegative(push.speed_m_s))
        return refused("speed", push.speed_m_s, "0 (not known) or positive, in m/s");
    if (push.speed_m_s >= speed_of_light_m_s)
        return refused("speed", push.speed_m_s, "slower than light, in m/s");
    return success();
}

/// 1/kg; 0 for a body that is held.
double inverseMassAt(const btRigidBody& body, const Push& push) {
    return body.getInvMass() > 0 ? body.computeImpulseDenominator(push.point, push.impulse_n_s.normalized())
                                 : 0;
}

/// Speed that a push gives to the place that it hits, m/s. A body that is held would be moved as fast by it
/// if it were not.
double speedBy(const Breakable& breakable, const Push& push) {
    const double given = inverseMassAt(*breakable.body, push);
    return push.impulse_n_s.length() * (given > 0 ? given : 1 / breakable.asset.mass());
}

/// A striker that is stopped with the impulse of the push from its speed; one that does not give way if no
/// faster striker is needed for that.
Mobility strikerOf(const btRigidBody& body, const ContactImpulse& contact, const Push& push) {
    const double both = contact.approach_m_s / push.impulse_n_s.length();
    const double inverse_mass = both - inverseMassAt(body, push);
    return inverse_mass > 1e-6 * both ? Mobility::ofPoint(1 / inverse_mass, contact.point) : Mobility{};
}

ContactImpulse asContact(const Breakable& breakable, const btTransform& asset_from_world, const Push& push) {
    const double impulse = push.impulse_n_s.length();
    const btVector3 direction = push.impulse_n_s.normalized();
    ContactImpulse contact;
    contact.point = fromBullet(asset_from_world * push.point);
    contact.normal = fromBullet(asset_from_world.getBasis() * direction).normalized();
    contact.impulse = impulse * contact.normal;
    contact.approach_m_s = std::max(push.speed_m_s, speedBy(breakable, push));
    contact.patch_radius_m = push.patch_radius_m;
    return contact;
}

/// The place that a contact strikes, world frame, m.
Vec3 onSurface(const Breakable& breakable, const ContactImpulse& contact) {
    const SurfaceSpot spot =
        nearestSurfacePoint(breakable.asset.solid()->surfaceTree(), contact.point, contact.normal);
    return fromBullet(breakable.placed(breakable.body->getWorldTransform()) * toBullet(spot.point));
}

}  // namespace

Status checkPushes(const std::vector<Push>& pushes) {
    if (pushes.empty()) return Error{"there is no push to strike the body with (an empty list)"};
    for (const Push& push : pushes)
        if (const Status valid = checkPush(push); !valid) return valid;
    return success();
}

Status checkSpeeds(const Breakable& breakable, const std::vector<Push>& pushes) {
    for (const Push& push : pushes) {
        const double speed = speedBy(breakable, push);
        if (speed < speed_of_light_m_s) continue;
        std::ostringstream sentence;
        sentence << "the push of " << words(push.impulse_n_s) << " N s at " << words(push.point)
                 << " m would move the body there at " << speed
                 << " m/s, faster than light; give a smaller impulse, or a point on the body";
        return Error{sentence.str()};
    }
    return success();
}

// Collision shapes stand off their surfaces, and bodies move while a blow waits: half the radius is forgiven.
Status checkPlaces(const Breakable& breakable, const std::vector<Push>& pushes) {
    const double forgiven = 0.5 * breakable.asset.solid()->boundingRadius();
    for (const Push& push : pushes) {
        const double distance = distanceTo(breakable, push.point);
        if (distance <= forgiven) continue;
        std::ostringstream sentence;
        sentence << "the point of the push is " << distance
                 << " m away from the surface of the body; give a point on it, as a ray test finds it";
        return Error{sentence.str()};
    }
    return success();
}

StruckBreakable asContacts(Breakable& breakable, const std::vector<Push>& pushes) {
    const btRigidBody& body = *breakable.body;
    const btTransform asset_from_world = breakable.placed(body.getWorldTransform()).inverse();
    StruckBreakable struck;
    struck.breakable = &breakable;
    struck.before = stateOf(body);
    double hardest = 0;
    for (const Push& push : pushes) {
        ContactImpulse contact = asContact(breakable, asset_from_world, push);
        contact.partner = static_cast<int>(struck.blow.partners.size());
        struck.blow.partners.push_back(strikerOf(body, contact, push));
        struck.blow.contacts.push_back(contact);
        const double impulse = push.impulse_n_s.length();
        if (!(impulse > hardest)) continue;
        hardest = impulse;
        struck.position = onSurface(breakable, contact);
        struck.normal = fromBullet(push.impulse_n_s / push.impulse_n_s.length());
    }
    return struck;
}

void push(btRigidBody& body, const std::vector<Push>& pushes) {
    if (body.isStaticOrKinematicObject()) return;
    body.activate();
    for (const Push& push : pushes)
        body.applyImpulse(push.impulse_n_s, push.point - body.getCenterOfMassPosition());
}

void pushLoose(const std::vector<std::unique_ptr<Breakable>>& pieces, const std::vector<Push>& pushes) {
    std::vector<btRigidBody*> loose;
    for (const auto& piece : pieces)
        if (piece->isDynamic()) loose.push_back(piece->body);
    for (const Push& push : pushes) {
        const auto hit = std::min_element(pieces.begin(), pieces.end(), [&](const auto& a, const auto& b) {
            return distanceTo(*a, push.point) < distanceTo(*b, push.point);
        });
        if (hit != pieces.end() && (*hit)->isDynamic()) pushAsOne(loose, push.impulse_n_s, push.point);
    }
}

std::vector<Push> moved(std::vector<Push> pushes, const btTransform& transform) {
    for (Push& push : pushes) {
        push.point = transform * push.point;
        push.impulse_n_s = transform.getBasis() * push.impulse_n_s;
    }
    return pushes;
}

double distanceTo(const Breakable& breakable, const btVector3& point) {
    const Vec3 x = fromBullet(breakable.placed(breakable.body->getWorldTransform()).inverse() * point);
    return (nearestSurfacePoint(breakable.asset.solid()->surfaceTree(), x, Vec3::Zero()).point - x).norm();
}

}  // namespace sherd
