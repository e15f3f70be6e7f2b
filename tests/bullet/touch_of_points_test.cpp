// When points of spinning bodies touch, and how fast.

#include "bullet/island/contact_motion.h"
#include "bullet/support.h"

namespace {

using namespace sherd;

const btVector3 up(0, 0, 1);
constexpr double step_s = 1.0 / 60;

/// A point of a body that moves and turns about y, at an angle ahead of where it is lowest.
PointMotion onAWheel(double radius, double angle, double spin, const btVector3& velocity) {
    PointMotion motion;
    motion.spin = btVector3(0, btScalar(spin), 0);
    motion.arm = btScalar(radius) * btVector3(btScalar(std::sin(angle)), 0, btScalar(-std::cos(angle)));
    motion.velocity = velocity + motion.spin.cross(motion.arm);
    return motion;
}

// It rolls along x: the point is at rest where it touches.
TEST(TouchOfPoints, AWheelThatRollsComesDownWithoutSpeed) {
    constexpr double radius = 0.1, spin = 20;
    for (const double angle : {0.05, 0.1, 0.2, 0.3}) {
        const PointMotion point = onAWheel(radius, angle, spin, btVector3(btScalar(radius * spin), 0, 0));
        const double height = radius * (1 - std::cos(angle));
        const double closing = -point.velocity.z();
        ASSERT_GT(closing, 0.09);
        const TouchOfPoints touch = touchOf(point, PointMotion(), up, -height, step_s);
        EXPECT_LT(touch.speed_m_s, 0.02 * closing) << angle;
        EXPECT_NEAR(touch.ago_s, -angle / spin, 0.02 * angle / spin) << angle;
    }
}

// Height of the point: radius (cos(lowest) - cos(angle)) above where it is, less the way that the body falls.
TEST(TouchOfPoints, IsThatOfTheCircle) {
    constexpr double radius = 0.2, spin = 15, falls_m_s = 2;
    for (const double angle_at_touch : {-0.6, -0.2, 0.3, 0.8})
        for (const double since_s : {-0.01, 0.004, 0.012}) {
            // Turning about y by a positive angle takes the lowest point towards -x: ahead is +x.
            const double angle = angle_at_touch - spin * since_s;
            const PointMotion point = onAWheel(radius, angle, spin, btVector3(0, 0, -falls_m_s));
            const double depth = falls_m_s * since_s + radius * (std::cos(angle) - std::cos(angle_at_touch));
            const double speed = falls_m_s + radius * spin * std::sin(angle_at_touch);
            if (speed < 0.5) continue;  // it comes up again by itself
            const TouchOfPoints touch = touchOf(point, PointMotion(), up, depth, step_s);
            EXPECT_NEAR(touch.ago_s, since_s, 1e-5) << angle_at_touch << ", " << since_s;
            EXPECT_NEAR(touch.speed_m_s, speed, 1e-3) << angle_at_touch << ", " << since_s;
            const TouchOfPoints of_other = touchOf(PointMotion(), point, -up, depth, step_s);
            EXPECT_EQ(touch.ago_s, of_other.ago_s);
            EXPECT_EQ(touch.speed_m_s, of_other.speed_m_s);
        }
}

// As without gravity where the step's own pull is taken off before: Bullet has added it to the speed.
TEST(TouchOfPoints, GravityPullsOnTheCircleToo) {
    constexpr double gravity = 9.81, radius = 0.2, spin = 15, falls_m_s = 2;
    PointMotion point = onAWheel(radius, 0.3, spin, btVector3(0, 0, -falls_m_s));
    point.fall = btScalar(-gravity);
    for (const double since_s : {-0.01, 0.008}) {
        const double before = 0.3 + spin * since_s;           // the angle then
        const double now = falls_m_s + gravity * step_s / 2;  // at the place where the body is
        const double depth =
            since_s * (now - gravity * since_s / 2) + radius * (std::cos(0.3) - std::cos(before));
        const TouchOfPoints touch = touchOf(point, PointMotion(), up, depth, step_s);
        EXPECT_NEAR(touch.ago_s, since_s, 1e-5) << since_s;
        EXPECT_NEAR(touch.speed_m_s, now - gravity * since_s + radius * spin * std::sin(before), 1e-3)
            << since_s;
    }
}

TEST(TouchOfPoints, WithoutSpinIsAsGravityHasIt) {
    PointMotion falls;
    falls.velocity = btVector3(1, 0, -3);
    falls.fall = btScalar(-9.81);
    for (const double depth : {-0.02, 0.0, 0.01}) {
        const TouchOfPoints touch = touchOf(falls, PointMotion(), up, depth, step_s);
        EXPECT_EQ(touch.ago_s, timeSinceTouch(3, depth, step_s));
        EXPECT_EQ(touch.speed_m_s, speedOfTouch(3, btScalar(9.81), depth, step_s));
    }
}

}  // namespace
