#pragma once

namespace sherd {

/// Two bodies as Hertz sees them: K. L. Johnson, Contact Mechanics (1985), 4.2 and 11.4.
struct HertzContact {
    double radius_m = 0;            ///< relative radius of curvature, 1/R = 1/R1 + 1/R2
    double contact_modulus_pa = 0;  ///< E*, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
};

/// Contact modulus E* of two materials, Pa.
double contactModulus(double youngs_1, double poisson_1, double youngs_2, double poisson_2);

/// Largest force of an elastic blow of `mass` at closing speed `speed` between otherwise rigid bodies, N.
double hertzPeakForce(const HertzContact& contact, double mass_kg, double speed_m_s);

/// Radius of the contact circle under a force, m.
double hertzPatchRadius(const HertzContact& contact, double force_n);

/// Relative radius of curvature at which a blow of that energy has a contact circle of `patch_radius_m` at
/// its peak, m.
double hertzRadiusOfPatch(double contact_modulus_pa, double patch_radius_m, double energy_j);

/// A strike, or several at once.
struct Impact {
    double mass_kg = 0;        ///< stopped by all contacts
    double speed_m_s = 0;      ///< the closing speed at which that mass carries the blow's energy
    double hertz_force_n = 0;  ///< peak force if the body were rigid but for the contact: an upper bound

    double energy() const { return 0.5 * mass_kg * speed_m_s * speed_m_s; }
};

/// A force pulse: half a sine wave of height `peak_force_n`.
struct ContactPulse {
    double peak_force_n = 0;
    double duration_s = 0;
};

/// How long half a sine wave takes to stop a momentum and throw it back: 2 m v = (2 / pi) F T.
double pulseDuration(double peak_force_n, double momentum_n_s);

/// The pulse of a blow whose energy is stored by two springs in series: the Hertz contact, and the struck
/// body itself, which stores `body_energy_j_n2` F^2. Hertz alone takes the body for rigid and so gives an
/// upper bound. No pulse is shorter than `shortest_s`, which lowers its force: the body never stores more
/// than the blow brings. Bullet's time step plays no part.
ContactPulse contactPulse(const Impact& impact, double body_energy_j_n2, double shortest_s);

}  // namespace sherd
