#include "bullet/applied_blow.h"

#include <cmath>
#include <sstream>

#include "bullet/conversions.h"

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
    return success();
}

/// 1/kg; 0 for a body that is held.
double inverseMassAt(const btRigidBody& body, const Push& push) {
    return body.getInvMass() > 0 ? body.computeImpulseDenominator(push.point, push.impulse_n_s.normalized())
                                 : 0;
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
    const double given = inverseMassAt(*breakable.body, push);
    // A body that is held would be moved as fast if it were not.
    const double own = given > 0 ? given : 1 / breakable.asset.mass();
    contact.approach_m_s = std::max(push.speed_m_s, impulse * own);
    contact.patch_radius_m = push.patch_radius_m;
    return contact;
}

}  // namespace

Status checkPushes(const std::vector<Push>& pushes) {
    if (pushes.empty()) return Error{"there is no push to strike the body with (an empty list)"};
    for (const Push& push : pushes)
        if (const Status valid = checkPush(push); !valid) return valid;
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
        struck.position = fromBullet(push.point);
        struck.normal = fromBullet(push.impulse_n_s / push.impulse_n_s.length());
    }
    return struck;
}

}  // namespace sherd
