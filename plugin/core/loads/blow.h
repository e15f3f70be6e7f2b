#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// One solved contact point, in the frame of the struck asset.
struct ContactImpulse {
    Vec3 point = Vec3::Zero();    ///< m
    Vec3 normal = Vec3::Zero();   ///< unit, the direction in which the body is pushed
    Vec3 impulse = Vec3::Zero();  ///< normal and friction impulse on the body, N s
    double approach_m_s =
        0;  ///< closing speed along the normal before the solve and without this step's gravity
    double closing_after_m_s = 0;  ///< the same after the solve; below zero when the bodies part
    double effective_mass_kg = 0;  ///< 1 / (n . (K_a + K_b) n) of the two bodies at the point
    double partner_radius_m = 0;   ///< radius of curvature of the striking shape; 0: not known or flat
    double patch_radius_m = 0;     ///< of the part of the surface that is struck; 0: Hertz's
    double partner_youngs_modulus_pa = 0;  ///< 0: the settings' value
    double partner_poisson_ratio = 0;
};

/// All contacts of one body in one step.
struct Blow {
    std::vector<ContactImpulse> contacts;
};

/// Sum of the normal impulses, N s.
double normalImpulse(const Blow& blow);

/// The part of a blow that one contact point carries, whatever the time step.
struct ContactShare {
    double mass_kg = 0;    ///< J / (speed before - speed after): the mass that the contact stops
    double speed_m_s = 0;  ///< closing speed; 0 for contacts that merely press
    double energy_j = 0;   ///< 1/2 m v^2
};

/// The share of a contact point. Points of the same blow share its mass in proportion to their impulses.
ContactShare contactShare(const ContactImpulse& contact);

/// Energy that all contacts together bring to the body at most, J.
double blowEnergy(const Blow& blow);

/// Where and along which direction a body is struck.
struct BlowAxis {
    Vec3 contact = Vec3::Zero();    ///< m
    Vec3 direction = Vec3::Zero();  ///< unit, or zero: not known
};

}  // namespace sherd
