#include "core/loads/blow.h"

#include <gtest/gtest.h>

namespace {

using namespace sherd;

ContactImpulse striking(double impulse, double approach, int partner = 0) {
    ContactImpulse c;
    c.normal = Vec3::UnitZ();
    c.impulse = Vec3(0.3 * impulse, 0, impulse);
    c.approach_m_s = approach;
    c.partner = partner;
    return c;
}

TEST(Blow, EnergyIsThatOfTheReducedMass) {
    EXPECT_NEAR(blowEnergy({{striking(1, 4)}, {Mobility::ofPoint(1)}}, 3, false), 0.5 * 0.75 * 16, 1e-12);
    EXPECT_NEAR(blowEnergy({{striking(1, 4)}, {Mobility::ofPoint(1)}}, 3, true), 0.5 * 16, 1e-12);
    for (const bool held : {false, true})
        EXPECT_NEAR(blowEnergy({{striking(1, 4)}, {}}, 3, held), 0.5 * 3 * 16, 1e-12)
            << "the partner does not give way";
}

TEST(Blow, WhatHoldsTheBodyAddsToIt) {
    Blow blow{{striking(1, 4), striking(2, 0, 1)}, {Mobility::ofPoint(1), Mobility{}}};
    EXPECT_TRUE(blow.isSupported());
    EXPECT_NEAR(blowEnergy(blow, 3, blow.isSupported()), 0.5 * 16, 1e-12);
}

TEST(Blow, ImpulsesDoNotCount) {
    // Neither how many points there are, nor what stopped the body, nor a push out of penetration.
    for (const double impulse : {0.001, 1.0, 100.0}) {
        Blow blow{{striking(impulse, 2), striking(0, 2), striking(0, 1.5)}, {Mobility::ofPoint(1)}};
        EXPECT_NEAR(blowEnergy(blow, 1, false), 0.5 * 0.5 * 4, 1e-12);
    }
    EXPECT_EQ(blowEnergy({{striking(0, 2)}, {Mobility::ofPoint(1)}}, 1, false), 0)
        << "went by without touching";
}

TEST(Blow, WhatHasMetCountsThoughSomethingElseStopsIt) {
    Blow blow{{striking(0, 2)}, {Mobility::ofPoint(1)}};
    blow.contacts[0].touched_s = 1e-3;
    EXPECT_NEAR(blowEnergy(blow, 1, false), 0.5 * 0.5 * 4, 1e-12);
    blow.contacts[0].touched_s = -1e-3;
    EXPECT_FALSE(blow.isStruck()) << "is still on its way";
}

TEST(Blow, WhatRunsIntoAWallBroughtMoreThanItClosesWith) {
    // A body of 1 kg at 2 m/s between a wall and what is 3 m/s faster: that has 5 m/s to lose.
    Blow blow{{striking(1, 2), striking(1, 3, 1)}, {Mobility{}, Mobility::ofPoint(4)}};
    blow.contacts[0].normal = blow.contacts[0].impulse = -Vec3::UnitZ();
    EXPECT_NEAR(blowEnergy(blow, 1, false), 0.5 * 1 * 4 + 0.5 * 4 * 25, 1e-12);
}

TEST(Blow, WhatMerelyPressesBringsNoEnergy) {
    EXPECT_EQ(blowEnergy({{striking(5, 0)}, {Mobility::ofPoint(1)}}, 1, false), 0);
    EXPECT_EQ(blowEnergy({{striking(5, -0.1)}, {Mobility::ofPoint(1)}}, 1, false), 0);
    EXPECT_EQ(blowEnergy({}, 1, false), 0);
}

}  // namespace
