#include "bullet/first_touch.h"

#include <cmath>

#include "core/loads/load_patch.h"

namespace sherd {

std::optional<FirstTouch> firstTouch(const SurfaceTree& surface, const Vec3& centre, const Vec3& velocity_m_s,
                                     double radius_m, double guess_ago_s, double longest_ago_s) {
    constexpr int most_rounds = 8;
    constexpr double later = 0.5, exact = 0.01;  // way and distance over the radius
    constexpr double grazing = 0.1;              // closing over the speed
    const double speed = velocity_m_s.norm();
    if (!(speed > 0 && radius_m > 0)) return std::nullopt;
    FirstTouch touch{{}, {}, longest_ago_s};
    // Newton's method from further out: the distance of what is round or flat is a convex function of the
    // way.
    for (int round = 0; round < most_rounds; ++round) {
        const Vec3 then = centre - touch.ago_s * velocity_m_s;
        const SurfaceSpot spot = nearestSurfacePoint(surface, then, velocity_m_s / speed);
        const double distance = (spot.point - then).norm();
        if (spot.triangle < 0 || !(distance > 0)) return std::nullopt;
        touch.point = spot.point;
        touch.push = (spot.point - then) / distance;
        const double closing = velocity_m_s.dot(touch.push);
        if (!(closing > grazing * speed)) return std::nullopt;
        if (std::abs(distance - radius_m) < exact * radius_m) {
            const bool is_then =
                touch.ago_s <= longest_ago_s && (guess_ago_s - touch.ago_s) * speed < later * radius_m;
            return is_then ? std::optional(touch) : std::nullopt;
        }
        touch.ago_s -= (distance - radius_m) / closing;
    }
    return std::nullopt;
}

}  // namespace sherd
