#include "bullet/strikes/recent_strikes.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>

#include "bullet/strikes/contact_collector.h"
#include "bullet/world/conversions.h"
#include "core/loads/strike.h"

namespace sherd {

namespace {

constexpr double lasts = 4.5;  // steps: what is a little off comes down after some

btVector3 velocityAt(const btCollisionObject& object, const btVector3& place) {
    const btRigidBody* body = btRigidBody::upcast(&object);
    return body ? body->getVelocityInLocalPoint(place - body->getCenterOfMassPosition()) : btVector3(0, 0, 0);
}

}  // namespace

void RecentStrikes::add(const Touch& touch, double time_s) {
    const btVector3 closing = velocityAt(*touch.partner, touch.place) - velocityAt(*touch.body, touch.place);
    left_.push_back({touch.body, touch.partner, touch.point, touch.push, closing.dot(touch.push), time_s});
}

void RecentStrikes::note(const std::vector<StruckBreakable>& struck, double time_s, double time_step_s) {
    constexpr double together_s = 5e-5;  // shorter than most contacts are
    left_.erase(std::remove_if(left_.begin(), left_.end(),
                               [&](const Left& left) { return left.time_s < time_s - lasts * time_step_s; }),
                left_.end());
    for (const StruckBreakable& one : struck) {
        if (one.breakable->isFragment()) continue;
        const ContactImpulse* leading = leadingTouch(one.blow, one.breakable->asset.solid()->mass());
        if (!leading) continue;
        const btTransform from_asset = one.breakable->placed(one.before.transform);
        for (std::size_t i = 0; i < one.blow.contacts.size(); ++i) {
            const ContactImpulse& contact = one.blow.contacts[i];
            if (contact.strikes() && std::abs(contact.touched_s - leading->touched_s) < together_s)
                add({one.breakable->body, one.partners[contact.partner], from_asset * toBullet(contact.point),
                     toBullet(one.pushes[i]), contact.point},
                    time_s);
        }
    }
}

bool RecentStrikes::goOnWith(const Touch& touch, double closing_m_s, double slowest_m_s, double time_s,
                             double time_step_s) {
    constexpr double near_m = 5e-3;
    constexpr btScalar alike = btScalar(0.9);  // cosine
    constexpr double faster = 1.1;             // where a body turns
    const bool is_known = std::any_of(left_.begin(), left_.end(), [&](const Left& left) {
        return left.body == touch.body && left.partner == touch.partner && left.time_s < time_s &&
               left.time_s > time_s - lasts * time_step_s &&
               closing_m_s < faster * left.closing_m_s + slowest_m_s && left.push.dot(touch.push) > alike &&
               (left.point - touch.point).norm() < near_m;
    });
    if (is_known) add(touch, time_s);
    return is_known;
}

RecentStrikes RecentStrikes::ofOthers(
    const std::function<const btCollisionObject*(const btCollisionObject*)>& other) const {
    RecentStrikes others;
    for (Left left : left_) {
        left.body = other(left.body);
        left.partner = other(left.partner);
        if (left.body && left.partner) others.left_.push_back(left);
    }
    return others;
}

}  // namespace sherd
