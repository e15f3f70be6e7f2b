#include "core/vibration/modal_impact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/numerics/pi.h"
#include "core/vibration/oscillators.h"

namespace sherd {
namespace {

StruckModes evenModes(int count, double spacing_rad_s, double compliance_m_n) {
    StruckModes modes;
    modes.rates_rad_s = spacing_rad_s * Eigen::ArrayXd::LinSpaced(count, 1, count);
    modes.work = std::sqrt(compliance_m_n) / modes.rates_rad_s * spacing_rad_s;
    return modes;
}

/// Against the response of a simple system to a half-sine pulse of duration T (Harris' Shock and Vibration
/// Handbook): with r = pi / (w T), (sin(pi t / T) - r sin(w t)) / (1 - r^2) while it lasts.
TEST(Oscillators, FollowAHalfSinePulse) {
    StruckModes modes;
    modes.rates_rad_s = Eigen::ArrayXd::LinSpaced(20, 0.3, 20);
    modes.work = Eigen::ArrayXd::Constant(20, 2);
    Oscillators oscillators(modes);
    constexpr int steps = 400;
    constexpr double duration = 1.5;
    oscillators.setStep(duration / steps);
    for (int step = 1; step <= steps; ++step) {
        oscillators.swing();
        oscillators.push(std::sin(pi * (step - 0.5) / steps));
        for (int mode = 0; mode < 20; ++mode) {
            const double w = modes.rates_rad_s[mode], r = pi / (w * duration), t = duration * step / steps;
            const double expected = 2 * (std::sin(pi * t / duration) - r * std::sin(w * t)) / (1 - r * r);
            ASSERT_NEAR(oscillators.amplitudes()[mode], expected, 2e-3) << w << " " << t;
        }
    }
}

// A step of force and free swinging after it, with d the damping: 1 - e^(-d w t) (cos(w' t) + d w / w' sin(w'
// t)), w' = w sqrt(1 - d^2).
TEST(Oscillators, OfLoadsAreDamped) {
    StruckModes modes;
    modes.rates_rad_s = Eigen::ArrayXd::Constant(2, 3);
    modes.work = Eigen::ArrayXd::Constant(2, 2);
    modes.ritz_vectors.resize(1, 1);  // of the second
    const auto answer = [](double t, double damping) {
        if (t <= 0) return 0.0;
        const double slower = std::sqrt(1 - damping * damping), angle = 3 * slower * t;
        return 2 * (1 - std::exp(-3 * damping * t) * (std::cos(angle) + damping / slower * std::sin(angle)));
    };
    Oscillators oscillators(modes);
    oscillators.setStep(0.05);
    for (int step = 1; step <= 100; ++step) {
        oscillators.swing();
        if (step <= 30) oscillators.push(1);
        for (int mode = 0; mode < 2; ++mode) {
            const double damping = mode == 0 ? 0 : StruckModes::ritz_damping;
            EXPECT_NEAR(oscillators.amplitudes()[mode],
                        answer(0.05 * step, damping) - answer(0.05 * (step - 30), damping), 1e-12);
        }
    }
}

const Impact impact{0.1, 2, 4000};

TEST(ModalImpact, OnABodyThatIsStiffIsHertzs) {
    const ModalImpact found = modalImpact(impact, {evenModes(10, 1e7, 1e-14), 1e-13, 0, 0}, 1e-9);
    EXPECT_NEAR(found.pulse.peak_force_n, 4000, 4);
    EXPECT_NEAR(found.pulse.duration_s, pulseDuration(4000, 0.2), 1e-3 * found.pulse.duration_s);
}

TEST(ModalImpact, OnABodyThatFollowsItIsTheStaticOne) {
    const StruckModes stiff = evenModes(10, 1e6, 1e-8);
    const StruckBody body{stiff, 3 * stiff.staticEnergy(), 0.5 * stiff.staticEnergy(), 0};
    const ModalImpact found = modalImpact(impact, body, 1e-9);
    const ContactPulse expected = contactPulse(impact, 2.5 * stiff.staticEnergy(), 1e-9);
    EXPECT_LT(expected.peak_force_n, 3900);
    EXPECT_NEAR(found.pulse.peak_force_n, expected.peak_force_n, 0.02 * expected.peak_force_n);
}

/// An infinite plate answers as a damper: y' = F / z with z = 8 sqrt(D m) (Zener 1941), and its vibrations
/// are evenly spaced. Against the equation of a Hertz contact and a damper.
TEST(ModalImpact, OnAWidePlateIsZeners) {
    for (const double inelasticity : {0.2, 1.0, 3.0}) {
        const double contact_s = pulseDuration(4000, 0.2);
        const double depth = 2.5 * impact.energy() / 4000, stiffness = 4000 / std::pow(depth, 1.5);
        const double z = impact.mass_kg / contact_s * 3 / inelasticity;
        double squeezed = 0, closing = impact.speed_m_s, body_m_s = 0, peak = 0, passed = 0;
        constexpr double step = 1e-8;
        for (double t = 0; t < 40 * contact_s && squeezed >= 0; t += step) {
            const double force = stiffness * std::pow(squeezed, 1.5);
            closing -= force / impact.mass_kg * step;
            body_m_s = force / z;
            squeezed += (closing - body_m_s) * step;
            peak = std::max(peak, force);
            passed += force * step;
            if (squeezed <= 0 && closing < 0) break;
        }
        // sum over n of work^2 w^2 cos(w t) is a pulse of the area pi work^2 w^2 / (2 spacing), half of it
        // after the force: a damper of 1 / z.
        const double spacing = pi / (60 * contact_s);
        StruckModes modes;
        modes.rates_rad_s = spacing * Eigen::ArrayXd::LinSpaced(3000, 0.5, 2999.5);
        modes.work = std::sqrt(2 * spacing / (pi * z)) / modes.rates_rad_s;
        const ModalImpact found = modalImpact(impact, {modes, modes.staticEnergy(), 0, 0}, 1e-9);
        EXPECT_NEAR(found.pulse.peak_force_n, peak, 0.03 * peak) << inelasticity;
        EXPECT_NEAR(found.pulse.duration_s, 0.5 * pi * passed / peak, 0.05 * found.pulse.duration_s);
    }
}

TEST(ModalImpact, AShortestContactSoftensTheBlow) {
    const ModalImpact found = modalImpact(impact, {evenModes(10, 1e7, 1e-14), 1e-13, 0, 0}, 1e-3);
    EXPECT_NEAR(found.pulse.duration_s, 1e-3, 1e-5);
    EXPECT_NEAR(found.pulse.peak_force_n, pi * 0.2 / 1e-3, 10);
}

TEST(ModalImpact, StatesHaveNoMoreEnergyThanTheBlow) {
    for (const double spacing : {1e2, 1e3, 1e4, 1e5}) {
        const StruckModes modes = evenModes(60, spacing, 1e-6);
        const ModalImpact found = modalImpact(impact, {modes, 1.1 * modes.staticEnergy(), 0, 0}, 1e-9);
        ASSERT_FALSE(found.pressed.empty());
        for (const auto* states : {&found.pressed, &found.ringing})
            for (const VibrationState& state : *states) {
                EXPECT_GT(state.energy_j, 0);
                EXPECT_LT(state.energy_j, 1.02 * impact.energy()) << spacing;
            }
    }
}

}  // namespace
}  // namespace sherd
