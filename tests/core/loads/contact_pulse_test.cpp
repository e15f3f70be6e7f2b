#include "core/loads/contact_pulse.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace sherd;

constexpr double pi = 3.14159265358979323846;

TEST(ContactPulse, HertzForceOfASphereOnAHalfSpace) {
    // Johnson (1985), Eq. 11.23-11.25: d = (15 m v^2 / (16 sqrt(R) E*))^(2/5), F = 4/3 E* sqrt(R) d^1.5.
    const HertzContact contact{0.01, 4e10};
    const double mass = 0.3, speed = 2;
    const double d = std::pow(15 * mass * speed * speed / (16 * std::sqrt(0.01) * 4e10), 0.4);
    EXPECT_NEAR(hertzPeakForce(contact, mass, speed), 4.0 / 3.0 * 4e10 * 0.1 * std::pow(d, 1.5), 1e-6);
    EXPECT_NEAR(hertzPatchRadius(contact, hertzPeakForce(contact, mass, speed)), std::sqrt(0.01 * d), 1e-12);
}

TEST(ContactPulse, EnergyIsSharedBetweenContactAndBody) {
    const HertzContact contact{0.02, 3e10};
    const double mass = 0.5, speed = 3, energy = 0.5 * mass * speed * speed;
    const double hertz = hertzPeakForce(contact, mass, speed);
    for (const double stored : {1e-12, 1e-10, 1e-8, 1e-6}) {
        const ContactPulse pulse = contactPulse({mass, speed, hertz}, stored, 0);
        const double f = pulse.peak_force_n;
        EXPECT_LT(f, hertz);
        EXPECT_NEAR(stored * f * f + energy * std::pow(f / hertz, 5.0 / 3.0), energy, 1e-9 * energy);
        EXPECT_NEAR(2 / pi * f * pulse.duration_s, 2 * mass * speed, 1e-9);
    }
    EXPECT_NEAR(contactPulse({mass, speed, hertz}, 0, 0).peak_force_n, hertz, 1e-9 * hertz);
}

TEST(ContactPulse, TheShortestDurationLowersTheForceAtTheSameMomentum) {
    const ContactPulse pulse = contactPulse({1, 1, 1e9}, 0, 1e-3);
    EXPECT_DOUBLE_EQ(pulse.duration_s, 1e-3);
    EXPECT_NEAR(2 / pi * pulse.peak_force_n * pulse.duration_s, 2, 1e-12);
}

TEST(ContactPulse, ASlenderBodyTakesItsTime) {
    // A plaster rod of 1 m and 1 cm across, struck in its middle: as soft as a spring of 48 E I / l^3.
    const double stiffness = 48 * 4.5e9 * 1e-8 / 12, mass = 0.1, speed = 0.3;
    const ContactPulse pulse = contactPulse({mass, speed, 1000}, 0.5 / stiffness, 2e-5);
    EXPECT_LE(0.5 / stiffness * pulse.peak_force_n * pulse.peak_force_n, 0.5 * mass * speed * speed);
    EXPECT_NEAR(pulse.peak_force_n, speed * std::sqrt(mass * stiffness), 0.01 * pulse.peak_force_n);
    EXPECT_GT(pulse.duration_s, 1e-2);
}

TEST(ContactPulse, NoSpeedNoForce) {
    EXPECT_EQ(contactPulse({1, 0, 0}, 1e-9, 1e-5).peak_force_n, 0);
    EXPECT_EQ(contactPulse({1, 0, 10}, 1e-9, 1e-5).peak_force_n, 0);
}

TEST(ContactPulse, ContactModulusOfEqualBodiesIsHalfThePlaneStrainModulus) {
    EXPECT_NEAR(contactModulus(2e11, 0.3, 2e11, 0.3), 0.5 * 2e11 / (1 - 0.09), 1);
    EXPECT_NEAR(contactModulus(1e9, 0.2, 1e30, 0.2), 1e9 / 0.96, 1);
}

}  // namespace
