#include "bullet/strikes/applied_blow.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bullet/fragments/fragment_motion.h"
#include "bullet/island/contact_motion.h"
#include "bullet/world/body_checks.h"
#include "bullet/world/conversions.h"
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

/// How pushes, all at once, move the places that they hit along themselves, m/s. A body that is held would be
/// moved by them if it were not, as a mass.
std::vector<double> motionBy(const Breakable& breakable, const std::vector<Push>& pushes) {
    const btRigidBody& body = *breakable.body;
    const Vec3 centre = fromBullet(body.getCenterOfMassPosition());
    const Mobility mobility = canMove(body) ? mobilityOf(body, btTransform::getIdentity(), btVector3(0, 0, 0))
                                            : Mobility::ofPoint(breakable.asset.mass(), centre);
    Wrench sum = Wrench::Zero();
    for (const Push& push : pushes)
        sum += mobility.wrench(fromBullet(push.point), fromBullet(push.impulse_n_s));
    const Wrench motion = mobility.response(sum);
    std::vector<double> speeds;
    for (const Push& push : pushes)
        speeds.push_back(
            motion.dot(mobility.wrench(fromBullet(push.point), fromBullet(push.impulse_n_s).normalized())));
    return speeds;
}

/// Speeds that pushes give to the places that they hit, m/s. Where others push against one, it is what that
/// one does by itself.
std::vector<double> speedsBy(const Breakable& breakable, const std::vector<Push>& pushes) {
    std::vector<double> speeds = motionBy(breakable, pushes);
    for (std::size_t i = 0; i < pushes.size(); ++i)
        speeds[i] = std::max(speeds[i], motionBy(breakable, {pushes[i]}).front());
    return speeds;
}

/// A striker that is stopped with the impulse of the push from its speed, when the place that it hits has
/// come to move by `moved_m_s`; one that does not give way if no faster striker is needed for that.
Mobility strikerOf(const ContactImpulse& contact, double moved_m_s) {
    const double left = contact.approach_m_s - moved_m_s;
    return left > 1e-6 * contact.approach_m_s ? Mobility::ofPoint(contact.pushed() / left, contact.point)
                                              : Mobility{};
}

ContactImpulse asContact(const btTransform& asset_from_world, const Push& push, double speed_m_s) {
    const double impulse = push.impulse_n_s.length();
    const btVector3 direction = push.impulse_n_s.normalized();
    ContactImpulse contact;
    contact.point = fromBullet(asset_from_world * push.point);
    contact.normal = fromBullet(asset_from_world.getBasis() * direction).normalized();
    contact.impulse = impulse * contact.normal;
    contact.approach_m_s = std::max(double(push.speed_m_s), speed_m_s);
    contact.patch_radius_m = push.patch_radius_m;
    return contact;
}

/// Pushes at one place and in one direction are one, as though the same had given them: several strikers side
/// by side would press harder.
std::vector<Push> joined(const std::vector<Push>& pushes, double near_m) {
    constexpr btScalar alike = btScalar(0.95);  // cosine of the angle between directions that are one
    std::vector<Push> groups;
    for (const Push& push : pushes) {
        const btScalar impulse = push.impulse_n_s.length();
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const Push& group) {
            return (group.point - push.point).length() < std::max(near_m, group.patch_radius_m) &&
                   group.impulse_n_s.dot(push.impulse_n_s) > alike * impulse * group.impulse_n_s.length();
        });
        if (known == groups.end()) {
            groups.push_back(push);
            continue;
        }
        const btScalar share = impulse / (impulse + known->impulse_n_s.length());
        known->point += share * (push.point - known->point);
        known->speed_m_s += double(share) * (push.speed_m_s - known->speed_m_s);
        known->patch_radius_m = std::max(known->patch_radius_m, push.patch_radius_m);
        known->impulse_n_s += push.impulse_n_s;
    }
    return groups;
}

/// Whether a ray test of Bullet's may find a point on the body: it is in the box by which Bullet knows that.
bool isInBoxOf(const btRigidBody& body, const btVector3& point) {
    const btVector3 margin(gContactBreakingThreshold, gContactBreakingThreshold, gContactBreakingThreshold);
    btVector3 low, high;
    body.getAabb(low, high);
    return TestPointAgainstAabb2(low - margin, high + margin, point);
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
    const std::vector<double> speeds = speedsBy(breakable, pushes);
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        const double speed = speeds[i];
        if (speed < speed_of_light_m_s) continue;
        std::ostringstream sentence;
        sentence << "the push of " << words(pushes[i].impulse_n_s) << " N s at " << words(pushes[i].point)
                 << " m would move the body there at " << speed
                 << " m/s, faster than light; give a smaller impulse, or a point on the body";
        return Error{sentence.str()};
    }
    return success();
}

// Collision shapes stand off their surfaces, those of curved shards by more than half their radius, ray tests
// are wrong by a little, and bodies move while a blow waits.
Status checkPlaces(const Breakable& breakable, const std::vector<Push>& pushes) {
    const double forgiven = 0.5 * breakable.asset.solid()->boundingRadius();
    for (const Push& push : pushes) {
        if (isInBoxOf(*breakable.body, push.point)) continue;
        const double distance = distanceTo(breakable, push.point);
        if (distance <= forgiven) continue;
        std::ostringstream sentence;
        sentence << "the point of the push is " << distance
                 << " m away from the surface of the body; give a point on it, as a ray test finds it";
        return Error{sentence.str()};
    }
    return success();
}

StruckBreakable asContacts(Breakable& breakable, const std::vector<Push>& all_pushes) {
    const std::vector<Push> pushes = joined(
        all_pushes, breakable.fracture->contact.smallest_patch * breakable.asset.solid()->wallThickness());
    const btRigidBody& body = *breakable.body;
    const btTransform asset_from_world = breakable.placed(body.getWorldTransform()).inverse();
    StruckBreakable struck;
    struck.breakable = &breakable;
    struck.before = stateOf(body);
    struck.blow.free_turns = freeTurns(body, asset_from_world);
    const std::vector<double> speeds = speedsBy(breakable, pushes);
    const std::vector<double> moved =
        body.getInvMass() > 0 ? motionBy(breakable, pushes) : std::vector<double>(pushes.size());
    double hardest = 0;
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        const Push& push = pushes[i];
        ContactImpulse contact = asContact(asset_from_world, push, speeds[i]);
        contact.partner = static_cast<int>(i);
        struck.blow.partners.push_back(strikerOf(contact, moved[i]));
        struck.blow.contacts.push_back(contact);
        const double impulse = push.impulse_n_s.length();
        if (!(impulse > hardest)) continue;
        hardest = impulse;
        struck.position = onSurface(breakable, contact);
        struck.normal = fromBullet(push.impulse_n_s / impulse);
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
    std::vector<Push> on_loose;
    for (const Push& push : pushes) {
        const auto hit = std::min_element(pieces.begin(), pieces.end(), [&](const auto& a, const auto& b) {
            return distanceTo(*a, push.point) < distanceTo(*b, push.point);
        });
        if (hit != pieces.end() && (*hit)->isDynamic()) on_loose.push_back(push);
    }
    if (!on_loose.empty()) pushAsOne(loose, on_loose);
}

std::vector<Push> withSpeeds(const Breakable& breakable, std::vector<Push> pushes) {
    const std::vector<double> speeds = speedsBy(breakable, pushes);
    for (std::size_t i = 0; i < pushes.size(); ++i)
        pushes[i].speed_m_s = std::max(pushes[i].speed_m_s, speeds[i]);
    return pushes;
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
