#pragma once

#include <sherd/types.h>

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/loads/mobility.h"
#include "core/loads/stack.h"

namespace sherd {

class SurfaceTree;

/// Where a body touches another one, in its own frame.
struct TouchingSurface {
    std::shared_ptr<const SurfaceTree> surface;
    Vec3 point = Vec3::Zero();  ///< m
    Vec3 push = Vec3::Zero();   ///< unit, the direction in which the contact pushes it
    double wall_thickness_m = 0;
};

/// One solved contact point, in the frame of the struck asset.
struct ContactImpulse {
    Vec3 point = Vec3::Zero();    ///< m
    Vec3 normal = Vec3::Zero();   ///< unit, the direction in which the body is pushed
    Vec3 impulse = Vec3::Zero();  ///< normal and friction impulse on the body, N s
    /// Closing speed along the normal when the surfaces met; 0 or less for contacts that merely press, and
    /// for those of bodies at rest.
    double approach_m_s = 0;
    /// How long before the step's solve the surfaces met, s; below zero where they are still apart.
    double touched_s = 0;
    Vec3 slip_m_s = Vec3::Zero();  ///< velocity of the partner against the body along the surface
    double friction = -1;  ///< coefficient; below 0: not known, the force has the direction of the impulse
    int partner = 0;       ///< numbers the bodies that touch this one
    double partner_radius_m = 0;   ///< radius of curvature of the striking shape; 0: not known or flat
    bool partner_is_flat = false;  ///< a face of it is what touches
    double partner_reach_m = std::numeric_limits<double>::infinity();  ///< of that face, on all sides
    bool partner_is_ground = false;                                    ///< it stands still
    std::shared_ptr<const TouchingSurface> partner_surface;  ///< tells its curvature where the shape does not
    double patch_radius_m = 0;             ///< of the part of the surface that is struck; 0: Hertz's
    double partner_youngs_modulus_pa = 0;  ///< 0: the settings' value
    double partner_poisson_ratio = 0;

    double pushed() const { return impulse.dot(normal); }
    bool strikes() const { return approach_m_s > 0; }
    bool supports() const { return !strikes() && pushed() > 0; }
    bool hasMet() const { return pushed() > 0 || touched_s > 0; }
};

/// All contacts of one body in one step.
struct Blow {
    std::vector<ContactImpulse> contacts;
    std::vector<Mobility> partners;       ///< by their numbers; those that are not there do not give way
    Stack stack = {};                     ///< empty: what the partners touch in turn is not known
    std::optional<Mat3> free_turns = {};  ///< see Mobility::heldBack; none: the body turns freely

    Mobility partner(int number) const;
    /// All numbers of partners are below it.
    int partnerCount() const;
    /// Whether a partner strikes: some contact of it closes, and that has met or some impulse came of it.
    /// What has met may have none where something else stopped the partner as well, a little later.
    bool isStruckBy(int partner) const;
    /// The striking contacts of all partners that do.
    std::vector<const ContactImpulse*> strikes() const;
    /// Whether any partner does.
    bool isStruck() const;
    /// Whether nothing strikes the body itself, but a strike on another body may press on it.
    bool isSqueezed() const { return stack.strike.strikes() && !isStruck(); }
    /// Whether something touches the body without striking it.
    bool isSupported() const;
};

/// Sum of the normal impulses, N s.
double normalImpulse(const Blow& blow);

/// The mass that a partner and a free body of `mass_kg` stop between them at most, kg.
double stoppedMass(const Mobility& partner, double mass_kg);

/// What all strikes together bring at most.
struct BroughtBound {
    double mass_kg = 0;  ///< that is stopped at the closing speed that goes with the energy
    double energy_j = 0;
    bool is_sure = true;   ///< else more may come of spins: one partner pushes on several sides
    bool pinched = false;  ///< several partners strike: each may keep the body from giving way to others
};

/// What strikes bring to a body of `mass_kg` at most: whatever the body stands on or leans against, and
/// wherever on the body a partner touches first. `held`: something keeps the body from giving way, so that a
/// partner is stopped with all of its own mass. Partners that cannot give way bring what it takes to stop the
/// body's mass once, held or not.
BroughtBound broughtAtMost(const Blow& blow, double mass_kg, bool held);

/// Energy that a blow brings to a body at most, if that is sure, J: that of its strikes, or, of a body that
/// is squeezed, that of the strike on the other body.
double blowEnergy(const Blow& blow, double mass_kg, bool held);

/// Where and along which direction a body is struck.
struct BlowAxis {
    Vec3 contact = Vec3::Zero();    ///< m
    Vec3 direction = Vec3::Zero();  ///< unit, or zero: not known
    double radius_m = 0;            ///< root mean square distance of the forces from `contact`
};

}  // namespace sherd
