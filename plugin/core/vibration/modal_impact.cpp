#include "core/vibration/modal_impact.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"
#include "core/vibration/hardest_states.h"
#include "core/vibration/oscillators.h"

namespace sherd {

double StruckModes::slowestPeriod() const {
    return empty() ? 0 : 2 * pi / rates_rad_s[0];
}

namespace {

constexpr double same_time = 0.05;  // of the contact: states so close are one
constexpr double faint = 0.1;       // of the contact's strain energy

/// What is not in the modes is stiffer than these, and follows the force.
double restEnergy(const StruckBody& body) {
    return std::max(0.0, body.strain_energy_j_n2 - body.modes.staticEnergy());
}

/// Lets the body swing freely, and completes the impact.
void ring(const StruckBody& body, double contact_s, const HardestStates& pressed, Oscillators& oscillators,
          ModalImpact& impact) {
    constexpr double steps_per_contact = 10;
    constexpr int fewest = 60, most = 400;
    const double period = body.modes.slowestPeriod();
    const int steps =
        static_cast<int>(std::clamp(steps_per_contact * period / contact_s, 1.0 * fewest, 1.0 * most));
    HardestStates ringing(body.modes, restEnergy(body), true);
    oscillators.setStep(period / steps);
    for (int step = 1; step <= steps; ++step) {
        oscillators.swing();
        ringing.look(contact_s + step * period / steps, 0, oscillators);
    }
    impact.pressed = pressed.take(same_time * contact_s);
    double strain = 0;  // twice the energy of it
    for (const VibrationState& state : impact.pressed) strain = std::max(strain, state.modes.square().sum());
    impact.ringing = ringing.take(same_time * contact_s);
    for (VibrationState& state : impact.ringing)
        state.is_faint = state.modes.square().sum() <= faint * strain;
}

/// A Hertz contact, F = k d^(3/2), between bodies that are otherwise rigid.
struct HertzSpring {
    double duration_s, stiffness;

    HertzSpring(const Impact& impact, double shortest_s) {
        const double momentum = impact.mass_kg * impact.speed_m_s;
        duration_s = std::max(pulseDuration(impact.hertz_force_n, momentum), shortest_s);
        const double force = pi * momentum / duration_s;
        const double depth = 2.5 * impact.energy() / force;  // see hertzPeakForce
        stiffness = force / (depth * std::sqrt(depth));
    }

    /// F = k max(0, d - c F)^(3/2), of the contact and a compliance c in series that are shortened by d. By
    /// Newton's method on what is left for the contact, r + c k r^(3/2) = d: convex, and from above.
    double forceInSeries(double compliance_m_n, double shortening_m) const {
        const double soft = compliance_m_n * stiffness;
        if (!(shortening_m > 0) || !std::isfinite(soft)) return 0;
        double left = shortening_m;
        if (soft > 0) left = std::min(left, std::pow(shortening_m / soft, 2.0 / 3));
        constexpr int most_rounds = 20;
        constexpr double rounding = 1e-15;
        for (int round = 0; round < most_rounds && soft > 0; ++round) {
            const double root = std::sqrt(left);
            const double over = (left + soft * left * root - shortening_m) / (1 + 1.5 * soft * root);
            left -= over;
            if (!(over > rounding * shortening_m)) break;
        }
        return stiffness * left * std::sqrt(left);
    }
};

/// Twice what the contact would take if the body bent as a whole.
double longestContact(const Impact& impact, const StruckBody& body, double shortest_s) {
    const double energy = std::max(body.strain_energy_j_n2 - body.patch_energy_j_n2, 0.0);
    const double slow_s = contactPulse(impact, energy + body.others_energy_j_n2, shortest_s).duration_s;
    return 2 * std::max(slow_s, shortest_s);
}

/// How the contact feels the body: the share of every mode, and what gives way besides them.
struct Give {
    Eigen::ArrayXd of_modes;  ///< displacement at the contact over amplitude
    double rest_m_n = 0;
};

/// The energy of the patch belongs to the Hertz contact. It is taken off what is stiffest. As in the static
/// case the body keeps a tenth of its energy.
Give giveOf(const StruckBody& body) {
    constexpr double least_part = 0.1;
    double patch = std::min(body.patch_energy_j_n2, (1 - least_part) * body.strain_energy_j_n2);
    Give give{body.modes.work, 0};
    const double rest = restEnergy(body), off = std::min(rest, patch);
    give.rest_m_n = 2 * (rest - off + body.others_energy_j_n2);
    patch -= off;
    for (Eigen::Index mode = give.of_modes.size() - 1; mode >= 0 && patch > 0; --mode) {
        const double energy = 0.5 * body.modes.work[mode] * body.modes.work[mode];
        const double taken = std::min(energy, patch);
        if (taken > 0) give.of_modes[mode] *= 1 - taken / energy;
        patch -= taken;
    }
    return give;
}

}  // namespace

bool isQuasiStatic(double slowest_period_s, double duration_s) {
    constexpr double periods = 10;
    return duration_s > periods * slowest_period_s;
}

ModalImpact modalImpact(const Impact& impact, const StruckBody& body, double shortest_s) {
    ModalImpact found;
    if (!(impact.energy() > 0) || !(impact.hertz_force_n > 0)) return found;
    const HertzSpring hertz(impact, shortest_s);
    const double longest_s = longestContact(impact, body, shortest_s);
    constexpr double steps_per_contact = 100, most_steps = 4000;
    const double step_s = std::max(hertz.duration_s / steps_per_contact, longest_s / most_steps);

    const Give give = giveOf(body);
    Oscillators oscillators(body.modes);
    oscillators.setStep(step_s);
    HardestStates pressed(body.modes, restEnergy(body), false);
    // The force of a step is that at its end: how the modes give way to it in the step is a compliance as
    // well. A force from the step's beginning would excite modes that are faster than the steps without
    // bound.
    const double compliance_m_n = give.rest_m_n + (give.of_modes * oscillators.perNewton()).sum();
    double place = 0, speed = impact.speed_m_s, time = 0, passed = 0;
    while (time < longest_s) {
        time += step_s;
        place += speed * step_s;
        oscillators.swing();
        const double shortening = place - (give.of_modes * oscillators.amplitudes()).sum();
        const double force = hertz.forceInSeries(compliance_m_n, shortening);
        oscillators.push(force);
        speed -= force / impact.mass_kg * step_s;
        passed += force * step_s;
        if (!(force > 0) && speed <= 0) break;  // the body may swing back later: then it is struck anew
        pressed.look(time, force, oscillators);
        found.pulse.peak_force_n = std::max(found.pulse.peak_force_n, force);
    }
    // Half a sine wave passes on 2 F T / pi.
    found.pulse.duration_s = 0.5 * pi * passed / found.pulse.peak_force_n;
    ring(body, time, pressed, oscillators, found);
    return found;
}

}  // namespace sherd
