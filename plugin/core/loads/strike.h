#pragma once

#include <memory>
#include <vector>

#include "core/loads/blow.h"
#include "core/loads/contact_pulse.h"
#include "core/loads/footprint.h"
#include "core/loads/load_patch.h"
#include "core/loads/mobility.h"

namespace sherd {

/// A point at which a partner strikes.
struct StrikePoint {
    const ContactImpulse* contact = nullptr;
    SurfaceSpot spot;
    HertzContact hertz;
    double share = 0;          ///< of the strike's normal force; all points of a strike have 1
    Vec3 push = Vec3::Zero();  ///< direction of the force, with a normal part of 1
    double on_face_m = 0;      ///< radius of the part of a face that it stands for, m; or 0
    double closed_gap_m = 0;   ///< how far from the partner that part may be and be pressed, m
    bool is_tilted = false;    ///< the far edge of the face, which would tell how far it goes, does not touch
    std::shared_ptr<const Footprint> face = nullptr;  ///< what that face touches
};

/// All that strikes a body at one time. Without points, nothing does.
struct Strike {
    std::vector<StrikePoint> points;
    double body_mobility = 0;     ///< that the points feel of the free body, 1/kg
    double lasting_mobility = 0;  ///< of that, what those feel whose partners do not give way
    double partner_mobility = 0;  ///< that the points feel of the partners; 0 of those that do not give way
    double least_mobility = 0;    ///< that there is in any case: contacts give way by themselves
    double speed_m_s = 0;

    bool strikes() const { return !points.empty(); }
    /// The mass that is stopped if supports take the share `held` of the body's mobility away. A partner that
    /// cannot move brings nothing of its own: then it is the body that is stopped, and no support adds to
    /// that.
    double mass(double held) const;
    /// Of the peak forces of the contacts if both bodies were rigid but for them, N.
    double hertzForce(double held) const;
    /// How long the contacts take if the body gives way nowhere else, s.
    double hertzDuration() const;
};

/// The contact that strikes hard and is met first; nullptr if none strikes. It brings at least 0.64 of
/// the energy of the hardest, and most of those that are met at the same time. One across the way that closes
/// more slowly than others is not it: how deep it is over how fast it closes is longer ago than it was met.
const ContactImpulse* leadingTouch(const Blow& blow, double mass_kg);

/// How far a contact that is met `apart_s` after the leading one, or before it, is on its way when that
/// presses hardest, half a pulse after it was met: 1 to 0.
double presence(double apart_s, double duration_s);

/// Shares a strike out between its points, which are of `blow`, and sets what they feel of all bodies, and
/// the speed. `share` comes in as the presence of each: what is hardly there yet gives way. Frictionless
/// rigid bodies that meet at all points at once get the impulses p >= 0 with sum_j n_i . K_ij n_j p_j = v_i,
/// where all points share the struck body and those of one partner share that; where it leaves a choice, as
/// on four corners of a face, the points share evenly. Bullet's own impulses are no guide: how many points
/// there are, and which of them stop the body, depends on how deep a step took it in. Friction is that of a
/// rigid blow of each partner's resultant: it holds, or slides with its coefficient times the normal force.
void shareOut(const Mobility& body, const Blow& blow, Strike& strike);

/// The strike on another body of a stack; its point has no contact and no spot.
Strike strikeOn(const Stack& stack);

}  // namespace sherd
