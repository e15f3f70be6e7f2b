#pragma once

#include <sherd/types.h>

#include <functional>
#include <limits>
#include <vector>

class btCollisionObject;

namespace sherd {

struct StruckBreakable;

/// Where whole bodies were struck in the last two steps. Bullet stops two bodies in more than one step: of
/// what closes over a gap it leaves as much as closes that in the step, and of a face that lands it stops one
/// corner, or some more than others, and turns the body. What is left closes in the next step, at a speed
/// that the strike has counted already; taken for another strike it would come to a corner alone.
class RecentStrikes {
  public:
    /// Notes what touches a body at about the time of its leading strike, or before.
    void note(const std::vector<StruckBreakable>& struck, double time_s);

    /// Whether the step before that of `time_s` has counted a strike of that partner at about that point,
    /// which is in the asset's frame, and hardly slower.
    bool haveCounted(const btCollisionObject& body, const btCollisionObject& partner, const Vec3& point,
                     double approach_m_s, double time_s, double time_step_s) const;

    /// The same of other objects, without those of which there is none.
    RecentStrikes ofOthers(
        const std::function<const btCollisionObject*(const btCollisionObject*)>& other) const;

  private:
    struct Touch {
        const btCollisionObject *body, *partner;  // may be dead: compared only
        Vec3 point;
        double approach_m_s;
    };
    static constexpr double never_s = -std::numeric_limits<double>::infinity();
    std::vector<Touch> now_, before_;
    double now_s_ = never_s, before_s_ = never_s;
};

}  // namespace sherd
