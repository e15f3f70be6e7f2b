#include "bullet/strikes/recent_strikes.h"

#include <algorithm>
#include <utility>

#include "bullet/strikes/contact_collector.h"
#include "core/loads/strike.h"

namespace sherd {

void RecentStrikes::note(const std::vector<StruckBreakable>& struck, double time_s) {
    constexpr double together_s = 5e-5;  // shorter than most contacts are
    if (time_s > now_s_) {
        before_ = std::exchange(now_, {});
        before_s_ = std::exchange(now_s_, time_s);
    }
    for (const StruckBreakable& one : struck) {
        if (one.breakable->isFragment()) continue;
        const ContactImpulse* leading = leadingTouch(one.blow, one.breakable->asset.solid()->mass());
        if (!leading) continue;
        for (const ContactImpulse& contact : one.blow.contacts)
            if (contact.strikes() && contact.touched_s > leading->touched_s - together_s)
                now_.push_back({one.breakable->body, one.partners[contact.partner], contact.point,
                                contact.approach_m_s});
    }
}

bool RecentStrikes::haveCounted(const btCollisionObject& body, const btCollisionObject& partner,
                                const Vec3& point, double approach_m_s, double time_s,
                                double time_step_s) const {
    constexpr double near_m = 5e-3, steps = 1.5;
    constexpr double faster = 1.6;  // the other end of a rod that is stopped at one closes at 1.5 times that
    const bool is_now = now_s_ < time_s;  // else this step has noted some already
    if (!((is_now ? now_s_ : before_s_) > time_s - steps * time_step_s)) return false;
    const std::vector<Touch>& touches = is_now ? now_ : before_;
    return std::any_of(touches.begin(), touches.end(), [&](const Touch& touch) {
        return touch.body == &body && touch.partner == &partner &&
               approach_m_s < faster * touch.approach_m_s && (touch.point - point).norm() < near_m;
    });
}

RecentStrikes RecentStrikes::ofOthers(
    const std::function<const btCollisionObject*(const btCollisionObject*)>& other) const {
    RecentStrikes others = *this;
    for (std::vector<Touch>* touches : {&others.now_, &others.before_}) {
        for (Touch& touch : *touches) {
            touch.body = other(touch.body);
            touch.partner = other(touch.partner);
        }
        touches->erase(std::remove_if(touches->begin(), touches->end(),
                                      [](const Touch& touch) { return !touch.body || !touch.partner; }),
                       touches->end());
    }
    return others;
}

}  // namespace sherd
