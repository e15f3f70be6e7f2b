#pragma once

#include <vector>

#include "core/loads/blow.h"
#include "core/loads/contact_pulse.h"
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
};

/// All that one partner does.
struct Strike {
    std::vector<StrikePoint> points;
    double body_mobility = 0;     ///< that the points feel of the free body, 1/kg
    double partner_mobility = 0;  ///< 0 where the partner does not give way
    double speed_m_s = 0;

    /// The mass that is stopped if supports take the share `held` of the body's mobility away. A partner that
    /// cannot move brings nothing of its own: then it is the body that is stopped, and no support adds to
    /// that.
    double mass(double held) const;
    /// How long the contacts take if the body gives way nowhere else, s.
    double hertzDuration() const;
};

constexpr int any_partner = -1;

/// The contact of a partner that strikes hard and is met first; nullptr if none strikes. One across the way
/// that closes more slowly than others is not it: how deep it is over how fast it closes is longer ago than
/// it was met.
const ContactImpulse* leadingTouch(const std::vector<ContactImpulse>& contacts, int partner);

/// How far a contact that is met `apart_s` after the leading one, or before it, is on its way when that
/// presses hardest, half a pulse after it was met: 1 to 0.
double presence(double apart_s, double duration_s);

/// Shares the strike of `partner` out between its points, and sets what they feel of both bodies, and the
/// speed. `share` comes in as the presence of each. Frictionless rigid bodies that meet at all points at once
/// get the impulses p >= 0 with sum_j n_i . K_ij n_j p_j = v_i; where that leaves a choice, as on four
/// corners of a face, the points share evenly. Bullet's own impulses are no guide: how many points there are,
/// and which of them stop the body, depends on how deep a step took it in. Friction is that of a rigid blow
/// of the resultant: it holds, or slides with its coefficient times the normal force.
void shareOut(const Mobility& body, const Mobility& partner, Strike& strike);

/// The strike on another body of a stack; its point has no contact and no spot.
Strike strikeOn(const Stack& stack);

}  // namespace sherd
