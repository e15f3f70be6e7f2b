#pragma once

#include <LinearMath/btVector3.h>
#include <sherd/types.h>

#include <functional>
#include <vector>

class btCollisionObject;

namespace sherd {

struct StruckBreakable;

/// A place at which a body meets another one.
struct Touch {
    const btCollisionObject *body = nullptr, *partner = nullptr;
    btVector3 place = btVector3(0, 0, 0);  ///< world frame, m
    btVector3 push = btVector3(0, 0, 0);   ///< unit, the direction in which it pushes the body, world frame
    Vec3 point = Vec3::Zero();             ///< in the frame of the body's asset, m
};

/// What is left of strikes on whole bodies that steps have counted. Bullet stops two bodies in more than one
/// step: of what closes over a gap it leaves as much as closes that in the step, and of a face that lands it
/// stops one corner, or some more than others, and turns the body. What is left closes in the next steps:
/// taken for another strike it would come to a corner alone.
class RecentStrikes {
  public:
    /// Notes what touches a body at about the time of its leading strike, and how fast it still closes after
    /// the solve of the step that ends at `time_s`.
    void note(const std::vector<StruckBreakable>& struck, double time_s, double time_step_s);

    /// Whether a touch that closes so fast, but for `slowest_m_s`, is what the last steps have left of one
    /// that was counted; then what this step leaves of it is noted.
    bool goOnWith(const Touch& touch, double closing_m_s, double slowest_m_s, double time_s,
                  double time_step_s);

    /// The same of other objects, without those of which there is none.
    RecentStrikes ofOthers(
        const std::function<const btCollisionObject*(const btCollisionObject*)>& other) const;

  private:
    struct Left {
        const btCollisionObject *body, *partner;  // may be dead: compared only
        Vec3 point;
        btVector3 push;
        double closing_m_s, time_s;
    };
    void add(const Touch& touch, double time_s);

    std::vector<Left> left_;
};

}  // namespace sherd
