#include "core/loads/contact_pulse.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"

namespace sherd {

double contactModulus(double youngs_1, double poisson_1, double youngs_2, double poisson_2) {
    return 1 / ((1 - poisson_1 * poisson_1) / youngs_1 + (1 - poisson_2 * poisson_2) / youngs_2);
}

double hertzPeakForce(const HertzContact& contact, double mass_kg, double speed_m_s) {
    // F = (4/3) E* sqrt(R) d^(3/2); at rest all energy is stored: 1/2 m v^2 = (2/5) F d.
    const double stiffness = 4.0 / 3.0 * contact.contact_modulus_pa * std::sqrt(contact.radius_m);
    const double indentation = std::pow(1.25 * mass_kg * speed_m_s * speed_m_s / stiffness, 0.4);
    return stiffness * std::pow(indentation, 1.5);
}

double hertzPatchRadius(const HertzContact& contact, double force_n) {
    return std::cbrt(0.75 * force_n * contact.radius_m / contact.contact_modulus_pa);
}

double hertzRadiusOfPatch(double contact_modulus_pa, double patch_radius_m, double energy_j) {
    // a^2 = R d and F = (4/3) E* a d; at rest (2/5) F d is the energy.
    const double indentation = std::sqrt(15.0 / 8.0 * energy_j / (contact_modulus_pa * patch_radius_m));
    return patch_radius_m * patch_radius_m / indentation;
}

namespace {

/// The force F at which a spring and a Hertz contact in series store the energy e together: a F^2 + e (F /
/// F_hertz)^(5/3) = e.
double sharedForce(double hertz_force, double a, double e) {
    double low = 0, high = hertz_force;
    for (int i = 0; i < 60; ++i) {
        const double mid = 0.5 * (low + high);
        const double stored = a * mid * mid + e * std::pow(mid / hertz_force, 5.0 / 3.0);
        (stored < e ? low : high) = mid;
    }
    return 0.5 * (low + high);
}

}  // namespace

double pulseDuration(double peak_force_n, double momentum_n_s) {
    return pi * momentum_n_s / peak_force_n;
}

ContactPulse contactPulse(const Impact& impact, double body_energy_j_n2, double shortest_s) {
    ContactPulse pulse;
    if (!(impact.energy() > 0) || !(impact.hertz_force_n > 0)) return pulse;
    const double momentum = impact.mass_kg * impact.speed_m_s;
    const double force = sharedForce(impact.hertz_force_n, body_energy_j_n2, impact.energy());
    pulse.duration_s = std::max(pulseDuration(force, momentum), shortest_s);
    pulse.peak_force_n = pi * momentum / pulse.duration_s;
    return pulse;
}

}  // namespace sherd
