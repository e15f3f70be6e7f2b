#pragma once

#include <vector>

#include "core/loads/foundation.h"

namespace sherd {

/// What a body's foundations do at the moment at which a strike of 1 N presses hardest.
struct SupportAnswer {
    std::vector<PointForce> forces;  ///< N
    double sum_n = 0;                ///< of their sizes
    double held = 0;  ///< share of the struck body's mobility under the strike that they take away
    /// Strain energy of the other bodies that the strike goes through, J at 1 N, each as a rod.
    double others_energy_j = 0;
    std::vector<char> pressed = {};  ///< which of the springs are, see pressedSprings
};

/// The share of its static answer that a spring has given when a half sine wave of `duration_s` presses
/// hardest on a mass of angular frequency `omega`: with r = pi / (omega T)
///     D = (1 - r sin(pi / (2 r))) / (1 - r^2)
/// (Harris' Shock and Vibration Handbook, response of a simple system to a half-sine pulse). 0 for a short
/// pulse, which the mass takes up before the spring is pressed; 1 for a long one. What swings above the
/// static answer and back is left out: how a body rings is not what a quasi-static stress can tell.
double springShare(double omega_rad_s, double duration_s);

/// The share of a wave's force that has come through a body to a rigid base `delay_s` away when the half sine
/// wave at the other end is at its peak: 2 cos(pi delay / T) and at most 1; none after T / 2.
double waveShare(double delay_s, double duration_s);

/// The part of a struck body's mass that a strike sets going while it lasts, 0 to 1.
double movingShare(const ContactBody& body, double duration_s);

/// How the foundations answer while a strike lasts: the struck body and the partners that may move are rigid
/// bodies, and the springs between them only push. Each mode of that system answers statically, in part or
/// not at all, as the length of the strike has it (`springShare`). Of the struck body, no more moves than
/// what a flexural wave sets going in a wall meanwhile (C. Zener, Phys. Rev. 59 (1941) 669: an infinite plate
/// resists a force like a damper of 8 sqrt(D m)). There is no friction: what it could hold while the strike
/// lasts is the weight's share, not that of the time step.
///
/// With a `stack` the bodies that the partners touch in turn belong to the system, and the springs between
/// them: a brick in a column gives way as the column does. Without forces in `unit_strike` it is the stack's
/// own strike, on another body, that presses with 1 N.
SupportAnswer supportAnswer(const ContactBody& body, const std::vector<Foundation>& foundations,
                            const std::vector<PointForce>& unit_strike, double duration_s,
                            const Stack& stack = {}, const std::vector<char>& pressed_before = {});

}  // namespace sherd
