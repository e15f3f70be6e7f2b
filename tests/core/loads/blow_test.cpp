#include "core/loads/blow.h"

#include <gtest/gtest.h>

namespace {

using namespace sherd;

ContactImpulse contact(double impulse, double before, double after, double mass_bound) {
    ContactImpulse c;
    c.normal = Vec3::UnitZ();
    c.impulse = Vec3(0.3 * impulse, 0, impulse);
    c.approach_m_s = before;
    c.closing_after_m_s = after;
    c.effective_mass_kg = mass_bound;
    return c;
}

TEST(Blow, EnergyDoesNotDependOnHowFarTheStepGot) {
    // One kilogram at 4 m/s: stopped at once, stopped by a quarter (speculative contact), and thrown back.
    for (const double after : {0.0, 3.0, -2.0})
        EXPECT_NEAR(blowEnergy({{contact(4 - after, 4, after, 10)}}), 8, 1e-12) << after;
}

TEST(Blow, PointsOfOneContactShareTheMass) {
    Blow blow;
    for (int i = 0; i < 4; ++i) blow.contacts.push_back(contact(0.5, 2, 0, 1));
    EXPECT_NEAR(blowEnergy(blow), 2, 1e-12);
}

TEST(Blow, PenetrationPushBringsNoEnergy) {
    EXPECT_NEAR(blowEnergy({{contact(100, 1, 0, 2)}}), 1, 1e-12);  // bounded by the mass of the two bodies
    EXPECT_EQ(blowEnergy({{contact(5, 0, -1, 2)}}), 0);            // presses, does not strike
    EXPECT_EQ(blowEnergy({{contact(5, -0.1, -1, 2)}}), 0);
    EXPECT_EQ(blowEnergy({}), 0);
}

}  // namespace
