#include "core/loads/first_touch.h"

#include <cmath>

#include "core/loads/load_patch.h"
#include "core/numerics/mesh_measures.h"

namespace sherd {

namespace {

constexpr double alike = 0.996;  // cosine of the angle between directions that are one

Vec3 centreThen(const MovingBall& ball, double ago_s) {
    return ball.centre - ago_s * ball.velocity_m_s;
}

Vec3 outwardAt(const SurfaceTree& surface, const SurfaceSpot& spot) {
    return areaVector(cornersOf(surface.surface(), spot.triangle)).normalized();
}

/// The touch on the face that the ball touches near `place`, if the face is as flat as far as that. Edges are
/// no faces: nothing then.
std::optional<FirstTouch> touchOfFace(const SurfaceTree& surface, const MovingBall& ball,
                                      const SurfaceSpot& place, double about_ago_s) {
    constexpr double exact = 0.01;  // of the radius
    const Vec3 outward = outwardAt(surface, place);
    const double closing = -ball.velocity_m_s.dot(outward);
    if (!(closing > 0)) return std::nullopt;
    const double height = (centreThen(ball, about_ago_s) - place.point).dot(outward);
    const double ago_s = about_ago_s + (ball.radius_m - height) / closing;
    const Vec3 foot = centreThen(ball, ago_s) - ball.radius_m * outward;
    const SurfaceSpot there = nearestSurfacePoint(surface, foot, -outward);
    const bool is_on_it = there.triangle >= 0 && (there.point - foot).norm() < exact * ball.radius_m &&
                          outwardAt(surface, there).dot(outward) > alike;
    return is_on_it ? std::optional(FirstTouch{there.point, -outward, ago_s}) : std::nullopt;
}

}  // namespace

std::optional<FirstTouch> firstTouch(const SurfaceTree& surface, const MovingBall& ball,
                                     double longest_ago_s) {
    constexpr int most_rounds = 16;
    constexpr double exact = 0.01;   // of the radius
    constexpr double grazing = 0.1;  // closing over the speed
    const double speed = ball.velocity_m_s.norm();
    FirstTouch touch{{}, {}, longest_ago_s};
    // Newton's method from further out: the distance of what is round or flat is a convex function of the
    // way.
    for (int round = 0; round < most_rounds; ++round) {
        const Vec3 then = centreThen(ball, touch.ago_s);
        const SurfaceSpot spot = nearestSurfacePoint(surface, then, ball.velocity_m_s / speed);
        const double distance = (spot.point - then).norm(), left = distance - ball.radius_m;
        if (spot.triangle < 0 || !(distance > 0)) return std::nullopt;
        touch.point = spot.point;
        touch.push = (spot.point - then) / distance;
        const double closing = ball.velocity_m_s.dot(touch.push);
        const bool grazes = !(closing > grazing * speed);
        if (std::abs(left) < exact * ball.radius_m)
            return grazes || touch.ago_s > longest_ago_s ? std::nullopt : std::optional(touch);
        touch.ago_s -= left / (grazes ? speed : closing);  // what it passes by it is no nearer to than that
    }
    return std::nullopt;
}

std::optional<FirstTouch> trueTouch(const SurfaceTree& surface, const MovingBall& ball,
                                    const FirstTouch& known, double longest_ago_s) {
    constexpr double there = 0.05, later = 0.5, earlier = 2.5;  // of the radius
    if (!(ball.velocity_m_s.norm() > 0)) return std::nullopt;
    const Vec3 place = centreThen(ball, known.ago_s) + ball.radius_m * known.push;
    const SurfaceSpot spot = nearestSurfacePoint(surface, place, known.push);
    if (spot.triangle >= 0 && (spot.point - place).norm() < there * ball.radius_m) {
        if (outwardAt(surface, spot).dot(known.push) < -alike) return std::nullopt;
        return touchOfFace(surface, ball, spot, known.ago_s);
    }
    const auto touch = firstTouch(surface, ball, longest_ago_s);
    if (!touch) return std::nullopt;
    const double way = (touch->ago_s - known.ago_s) * ball.velocity_m_s.norm() / ball.radius_m;
    return way > -later && way < earlier ? touch : std::nullopt;
}

}  // namespace sherd
