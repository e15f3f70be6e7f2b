// Which vertices a fragment stands on.

#include "bullet/ground/standing_base.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace sherd;

Foot foot(btScalar x, btScalar y, btScalar above = 0) {
    return {btVector3(x, y, above), above, x, y};
}

/// Whether the point below the centre of mass is inside the hull of some feet, by all half planes.
bool carries(const std::vector<Foot>& feet) {
    for (int i = 0; i < 720; ++i) {
        const double angle = i * M_PI / 360, x = std::cos(angle), y = std::sin(angle);
        double furthest = -1e30;
        for (const Foot& f : feet) furthest = std::max(furthest, x * f.x + y * f.y);
        if (furthest < -1e-6) return false;
    }
    return true;
}

TEST(StandingBase, OfOneOrTwoFeetIsAllOfThem) {
    EXPECT_EQ(standingBase({foot(1, 2)}).size(), 1u);
    EXPECT_EQ(standingBase({foot(1, 2), foot(0, 2)}).size(), 2u);
    EXPECT_EQ(standingBase({foot(1, 2), foot(1, 2), foot(1, 2)}).size(), 1u) << "in one place";
    EXPECT_EQ(standingBase({foot(0, 0), foot(1, 1), foot(2, 2)}).size(), 2u) << "on one line";
}

TEST(StandingBase, HasTheLowest) {
    const std::vector<Foot> base =
        standingBase({foot(1, 1), foot(-1, 1), foot(0.1f, 0.1f, -0.5f), foot(-1, -1), foot(1, -1)});
    EXPECT_EQ(base.front().above, -0.5f);
}

TEST(StandingBase, OfASquareAndPointsWithinIsTheSquare) {
    std::vector<Foot> feet = {foot(1, 1, -0.01f), foot(-1, 1), foot(-1, -1), foot(1, -1)};
    for (int i = -4; i <= 4; ++i) feet.push_back(foot(0.1f * i, 0.2f));
    const std::vector<Foot> base = standingBase(feet);
    ASSERT_EQ(base.size(), 4u);
    for (const Foot& f : base) EXPECT_EQ(std::abs(f.x) * std::abs(f.y), 1);
}

TEST(StandingBase, IsUnderTheCentreOfMassWhereThatCanBe) {
    std::mt19937 random(3);
    std::uniform_real_distribution<btScalar> place(-1, 1), shift(-0.7f, 0.7f), height(0, 0.1f);
    int carried = 0;
    for (int round = 0; round < 2000; ++round) {
        const btScalar dx = shift(random), dy = shift(random);
        std::vector<Foot> feet;
        for (int i = 0; i < 12; ++i)
            feet.push_back(foot(place(random) + dx, place(random) + dy, height(random)));
        if (!carries(feet)) continue;
        ++carried;
        EXPECT_TRUE(carries(standingBase(feet))) << round;
    }
    EXPECT_GT(carried, 500);
}

}  // namespace
