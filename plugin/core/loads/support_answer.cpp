#include "core/loads/support_answer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/loads/spring_system.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// Of the partners, each as a rod: between forces that add up to F on both of its ends it stores
/// 1/2 c (F / 2)^2.
double othersEnergy(const SpringSystem& system, const Pressed& rest, const Stack& stack) {
    double energy = 0;
    for (const StackBody& body : stack.bodies) {
        const auto partner = system.partners.find(body.number);
        if (partner == system.partners.end()) continue;
        double both_ends = system.distant.partner == &partner->second ? 1 : 0;
        for (std::size_t i = 0; i < system.springs.size(); ++i)
            for (const SpringEnd& end : system.springs[i].ends)
                if (end.partner == &partner->second) both_ends += rest.forces_n[i];
        energy += 0.5 * body.compliance_m_n * both_ends * both_ends / 4;
    }
    return energy;
}

}  // namespace

double springShare(double omega_rad_s, double duration_s) {
    constexpr double slow = 1e-3;       // of a swing in the pulse: no answer, to rounding
    constexpr double statical = 0.643;  // r at which D is 1 for the first time
    if (omega_rad_s * duration_s < slow) return 0;
    const double r = pi / (omega_rad_s * duration_s);
    if (r <= statical) return 1;
    constexpr double near_one = 1e-4;  // where both sides of the quotient vanish
    if (std::abs(r - 1) < near_one) return 0.5;
    return (1 - r * std::sin(pi / (2 * r))) / (1 - r * r);
}

double waveShare(double delay_s, double duration_s) {
    return delay_s < duration_s / 2 ? std::min(1.0, 2 * std::cos(pi * delay_s / duration_s)) : 0;
}

double movingShare(const ContactBody& body, double duration_s) {
    const Material& m = body.material;
    const double wall = body.wall_thickness_m, nu = m.poisson_ratio;
    const double bending = m.youngs_modulus_pa * std::pow(wall, 3) / (12 * (1 - nu * nu));
    const double damping = 8 * std::sqrt(bending * m.density_kg_m3 * wall);
    return std::min(1.0, damping * duration_s / pi * body.mobility.inverse_mass);
}

SupportAnswer supportAnswer(const ContactBody& body, const std::vector<Foundation>& foundations,
                            const std::vector<PointForce>& unit_strike, double duration_s, const Stack& stack,
                            const std::vector<char>& pressed_before) {
    SupportAnswer answer;
    const SpringSystem system = springSystemOf(body, foundations, unit_strike, duration_s, stack);
    if (system.springs.empty()) return answer;
    Pressed rest = pressedSprings(system, duration_s, pressed_before);
    answer.held = rest.held;
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        const Spring& spring = system.springs[i];
        if (!spring.is_own || !(rest.forces_n[i] > 0)) continue;
        answer.forces.push_back({spring.position, rest.forces_n[i] * spring.push});
        answer.sum_n += rest.forces_n[i];
    }
    answer.others_energy_j = othersEnergy(system, rest, stack);
    answer.pressed = std::move(rest.pressed);
    return answer;
}

}  // namespace sherd
