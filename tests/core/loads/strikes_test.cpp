#include <gtest/gtest.h>

#include <cmath>

#include "core/loads/contact_loads.h"
#include "core/loads/strike.h"

namespace {

using namespace sherd;

constexpr double pi = 3.14159265358979323846;

Mobility block(double mass, const Vec3& size) {
    Mobility m;
    m.inverse_mass = 1 / mass;
    for (int k = 0; k < 3; ++k)
        m.inverse_inertia(k, k) = 12 / (mass * (size.squaredNorm() - size[k] * size[k]));
    return m;
}

ContactImpulse contact(const Vec3& point, double speed = 2) {
    ContactImpulse c;
    c.point = point;
    c.normal = Vec3::UnitZ();
    c.impulse = Vec3::UnitZ();
    c.approach_m_s = speed;
    c.friction = 0;
    return c;
}

/// The strike of all contacts, met at the same time.
Strike together(const std::vector<ContactImpulse>& contacts, const Mobility& body,
                const Mobility& partner = {}) {
    Strike strike;
    for (const ContactImpulse& c : contacts) strike.points.push_back({&c, {}, {0.01, 1e10}, 1, c.normal});
    shareOut(body, {{}, {partner}}, strike);
    return strike;
}

TEST(Strikes, CornersOfAFaceShareEvenlyAndStopTheWholeBody) {
    std::vector<ContactImpulse> corners;
    for (const double x : {-0.1, 0.1})
        for (const double y : {-0.2, 0.2}) corners.push_back(contact(Vec3(x, y, -0.05)));
    const Strike strike = together(corners, block(3, Vec3(0.2, 0.4, 0.1)));
    for (const StrikePoint& point : strike.points) EXPECT_NEAR(point.share, 0.25, 1e-12);
    EXPECT_NEAR(strike.mass(0), 3, 1e-3);
    EXPECT_NEAR(strike.speed_m_s, 2, 1e-12);
}

TEST(Strikes, PointsOffTheMiddleShareByTheirLevers) {
    // A bar that lands flat on two points, 0.1 m and 0.3 m from its middle: moments cancel at 3 to 1.
    const std::vector<ContactImpulse> points{contact(Vec3(-0.1, 0, 0)), contact(Vec3(0.3, 0, 0))};
    const Strike strike = together(points, block(3, Vec3(1, 0.01, 0.01)));
    EXPECT_NEAR(strike.points[0].share, 0.75, 0.02);
    EXPECT_NEAR(strike.mass(0), 3, 0.02);
}

TEST(Strikes, ABarStruckAtItsEndTurnsAway) {
    const std::vector<ContactImpulse> end{contact(Vec3(0.5, 0, 0))};
    EXPECT_NEAR(together(end, block(3, Vec3(1, 0, 0.001))).mass(0), 3 / 4.0, 1e-5)
        << "1/m + (l/2)^2 / (m l^2 / 12)";
    Mobility ball = block(1, Vec3(0.01, 0.01, 0.01));
    ball.centre = Vec3(0.5, 0, -0.005);
    const Strike by_a_ball = together(end, block(3, Vec3(1, 0, 0.001)), ball);
    EXPECT_NEAR(by_a_ball.mass(0), 1 / (4 / 3.0 + 1), 1e-3);
    EXPECT_NEAR(by_a_ball.mass(1), 1, 1e-3) << "held in place";
}

TEST(Strikes, FrictionHoldsOrSlides) {
    // A thin bar of length l at 45 degrees that falls on its end: with the end held it turns about it.
    const double half = 0.5 / std::sqrt(2.0);
    std::vector<ContactImpulse> end{contact(Vec3(half, 0, -half))};
    Mobility bar = block(3, Vec3(1, 1e-3, 1e-3));
    const Eigen::AngleAxisd turn(pi / 4, Vec3::UnitY());
    bar.inverse_inertia = turn * bar.inverse_inertia * turn.inverse();
    const auto struck = [&](double friction) {
        end[0].friction = friction;
        return together(end, bar);
    };
    // Held: v = 2 m/s down turns into a spin of (3/2) v cos / l about the end; normal and lateral momentum
    // follow.
    const double spin = 1.5 * 2 * std::sqrt(0.5), middle = spin * 0.5;
    const double normal = 3 * (2 - middle * std::sqrt(0.5)), lateral = 3 * middle * std::sqrt(0.5);
    const Strike held = struck(10);
    EXPECT_NEAR(std::abs(held.points[0].push.x()), lateral / normal, 2e-3);
    EXPECT_NEAR(held.mass(0), normal / 2, 5e-3);
    EXPECT_NEAR(struck(0.2).points[0].push.head<2>().norm(), 0.2, 1e-9);
    EXPECT_NEAR(struck(0).mass(0), 3 / (1 + 12 * half * half), 5e-3);
}

TEST(Strikes, ARollingBallPushesAlongWithTwoSevenths) {
    std::vector<ContactImpulse> point{contact(Vec3::Zero())};
    point[0].friction = 1;
    point[0].slip_m_s = Vec3(1, 0, 0);
    Mobility ball;
    ball.centre = Vec3(0, 0, -0.1);
    ball.inverse_mass = 1;
    ball.inverse_inertia = Mat3::Identity() / (0.4 * 0.01);
    Mobility wall;
    wall.inverse_mass = 1e-9;
    EXPECT_NEAR(together(point, wall, ball).points[0].push.x(), 2 / 7.0 * 1 / 2.0, 1e-6);
}

TEST(Strikes, WithoutACoefficientTheForceHasTheDirectionOfTheImpulse) {
    std::vector<ContactImpulse> point{contact(Vec3::Zero())};
    point[0].friction = -1;
    point[0].impulse = Vec3(1, 0, 4);
    EXPECT_TRUE(together(point, block(1, Vec3(1, 1, 1))).points[0].push.isApprox(Vec3(0.25, 0, 1)));
}

TEST(Strikes, WhatIsMetLaterIsNotThereYet) {
    EXPECT_EQ(presence(0, 1e-3), 1);
    EXPECT_NEAR(presence(0.25e-3, 1e-3), std::sqrt(0.5), 1e-12);
    EXPECT_EQ(presence(0.5e-3, 1e-3), 0);
    EXPECT_EQ(presence(-0.25e-3, 1e-3), presence(0.25e-3, 1e-3)) << "met before the leading one";
    EXPECT_EQ(presence(-0.5e-3, 1e-3), 0);
    Blow blow{{contact(Vec3::Zero()), contact(Vec3::UnitX()), contact(Vec3::UnitY())}, {}};
    blow.contacts[1].touched_s = 2e-3;
    EXPECT_EQ(leadingTouch(blow, 1), &blow.contacts[1]);
    EXPECT_EQ(leadingTouch({}, 1), nullptr);
}

TEST(Strikes, WhatClosesSlowlyDoesNotLead) {
    Blow blow{{contact(Vec3::Zero()), contact(Vec3::UnitX())}, {}};
    blow.contacts[1].touched_s = 2e-3;
    blow.contacts[1].approach_m_s = 0.7 * blow.contacts[0].approach_m_s;
    EXPECT_EQ(leadingTouch(blow, 1), &blow.contacts[0]);
    blow.contacts[1].approach_m_s = 0.9 * blow.contacts[0].approach_m_s;
    EXPECT_EQ(leadingTouch(blow, 1), &blow.contacts[1]);
}

TEST(Strikes, SeveralBodiesThatDoNotGiveWayStopABodyOnce) {
    std::vector<ContactImpulse> corners;
    for (const double x : {-0.1, 0.1})
        for (const double y : {-0.2, 0.2}) {
            corners.push_back(contact(Vec3(x, y, -0.05)));
            corners.back().partner = static_cast<int>(corners.size()) - 1;
        }
    const Mobility body = block(3, Vec3(0.2, 0.4, 0.1));
    const Strike strike = together(corners, body);
    for (const StrikePoint& point : strike.points) EXPECT_NEAR(point.share, 0.25, 1e-12);
    EXPECT_NEAR(strike.mass(0), 3, 1e-9);
    EXPECT_NEAR(strike.mass(1), 3, 1e-9);
    EXPECT_NEAR(blowEnergy({corners, {}}, 3, false), 0.5 * 3 * 4, 1e-9);
}

TEST(Strikes, BallsThatHitTogetherAreStoppedByTheBodyTogether) {
    // Four of 1 kg against 3 kg: 1/m = 1/3 + 1/4.
    std::vector<ContactImpulse> hits;
    Blow blow;
    for (const double x : {-0.1, 0.1})
        for (const double y : {-0.1, 0.1}) {
            hits.push_back(contact(Vec3(x, y, -0.05)));
            hits.back().partner = static_cast<int>(blow.partners.size());
            blow.partners.push_back(Mobility::ofPoint(1));
        }
    Strike strike;
    for (const ContactImpulse& c : hits) strike.points.push_back({&c, {}, {0.01, 1e10}, 1, c.normal});
    shareOut(block(3, Vec3(1, 1, 0.1)), blow, strike);
    EXPECT_NEAR(strike.mass(0), 12 / 7.0, 1e-9);
    EXPECT_NEAR(strike.mass(1), 4, 1e-9) << "held in place";
}

TEST(Strikes, WhatPinchesABodyIsStoppedWithAllItsMass) {
    std::vector<ContactImpulse> sides{contact(Vec3(0, 0, -0.05)), contact(Vec3(0, 0, 0.05))};
    sides[1].normal = sides[1].impulse = -Vec3::UnitZ();
    sides[1].partner = 1;
    Strike strike;
    for (const ContactImpulse& c : sides) strike.points.push_back({&c, {}, {0.01, 1e10}, 1, c.normal});
    const Blow blow{sides, {Mobility::ofPoint(100), Mobility::ofPoint(100)}};
    shareOut(block(1, Vec3(0.1, 0.1, 0.1)), blow, strike);
    EXPECT_NEAR(strike.mass(0), 200, 1e-6) << "and not 2 x 0.99 kg";
    EXPECT_TRUE(broughtAtMost(blow, 1, false).pinched);
    EXPECT_NEAR(blowEnergy(blow, 1, false), 0.5 * 200 * 4, 1e-9);
}

TEST(Strikes, SupportsNeverLowerWhatIsStopped) {
    // A body between a wall and a ram: what holds it takes nothing from either.
    std::vector<ContactImpulse> sides{contact(Vec3(0, 0, -0.05), 1), contact(Vec3(0.02, 0, 0.05), 2)};
    sides[1].normal = sides[1].impulse = -Vec3::UnitZ();
    sides[1].partner = 1;
    Strike strike;
    for (const ContactImpulse& c : sides) strike.points.push_back({&c, {}, {0.01, 1e10}, 1, c.normal});
    const Blow blow{sides, {Mobility{}, Mobility::ofPoint(100)}};
    shareOut(block(1, Vec3(0.1, 0.1, 0.1)), blow, strike);
    for (double held = 0; held < 1; held += 0.25)
        EXPECT_GE(strike.mass(held + 0.25), strike.mass(held) * (1 - 1e-12)) << held;
    EXPECT_LE(impactOf(strike, 1).energy(), blowEnergy(blow, 1, true));
}

TEST(Strikes, WhatIsHardlyThereTakesHardlyAnything) {
    // Two equal balls side by side, the second ever later: from both to the first alone, without a dip.
    std::vector<ContactImpulse> hits{contact(Vec3(-0.1, 0, 0)), contact(Vec3(0.1, 0, 0), 2.5)};
    hits[1].partner = 1;
    const Blow blow{hits, {Mobility::ofPoint(1), Mobility::ofPoint(1)}};
    const Mobility body = block(3, Vec3(1, 1, 0.1));
    const auto energyAt = [&](double presence) {
        Strike strike;
        for (const ContactImpulse& c : hits) strike.points.push_back({&c, {}, {0.01, 1e10}, 1, c.normal});
        strike.points[1].share = presence;
        shareOut(body, blow, strike);
        return impactOf(strike, 0).energy();
    };
    const double alone = 0.5 * 4 * together({hits[0]}, body, Mobility::ofPoint(1)).mass(0);
    double last = energyAt(1);
    EXPECT_GT(last, 1.5 * alone);
    for (double presence = 0.9; presence > 0.01; presence *= 0.8) {
        const double energy = energyAt(presence);
        EXPECT_LE(energy, last * 1.001) << presence;
        EXPECT_GE(energy, alone * 0.98) << presence;
        last = energy;
    }
    EXPECT_NEAR(last, alone, 0.02 * alone);
}

TEST(Strikes, AWedgeIsStoppedWhollyBetweenWhatItFallsInto) {
    // Slopes of 60 degrees close at half the speed along their normals, 4 m/s down.
    std::vector<ContactImpulse> slopes;
    for (const int side : {-1, 1}) {
        slopes.push_back(contact(Vec3::Zero(), 4 * 0.5));
        slopes.back().normal = Vec3(side * std::sqrt(0.75), 0, 0.5);
        slopes.back().slip_m_s = Vec3(0, 0, 4) - 4 * 0.5 * slopes.back().normal;
        slopes.back().partner = (side + 1) / 2;
    }
    const Strike strike = together(slopes, block(3, Vec3(0.1, 0.1, 0.1)));
    EXPECT_NEAR(impactOf(strike, 0).energy(), 0.5 * 3 * 16, 1e-6);
    EXPECT_NEAR(blowEnergy({slopes, {}}, 3, false), 0.5 * 3 * 16, 1e-9);
}

TEST(Strikes, OfThoseMetAtTheSameTimeTheHardestLeads) {
    Blow blow{{contact(Vec3::Zero(), 3), contact(Vec3::UnitX(), 3.5)}, {}};
    EXPECT_EQ(leadingTouch(blow, 1), &blow.contacts[1]);
}

TEST(Strikes, TheOneWithMostEnergyLeadsHoweverSlow) {
    Blow blow{{contact(Vec3::Zero(), 4), contact(Vec3::UnitX(), 2)},
              {Mobility::ofPoint(0.01), Mobility::ofPoint(10)}};
    blow.contacts[0].touched_s = 2e-3;
    blow.contacts[1].partner = 1;
    EXPECT_EQ(leadingTouch(blow, 10), &blow.contacts[1]);
}

}  // namespace
