#pragma once

#include <vector>

#include "core/loads/contact_loads.h"

namespace sherd {

/// A quadrature point of a foundation.
struct FoundationPoint {
    Vec3 position = Vec3::Zero();  ///< m
    double share = 0;              ///< of the foundation's stiffness; all points have 1
};

/// The part of the surface with which a struck body rests on a partner that does not strike it, or leans
/// against one: a bed of springs that only push (Winkler). What the springs answer to a strike follows from
/// how the body moves while the strike lasts (`supportAnswer`), not from the impulses of the step, which are
/// mostly those of its weight and know nothing of the strike's duration.
struct Foundation {
    Vec3 push = Vec3::Zero();  ///< unit, the direction in which it pushes the body
    std::vector<FoundationPoint> points;
    double stiffness_n_m = 0;  ///< of all springs
    double distance_m = 0;     ///< from where the body is struck
    int partner_number = 0;    ///< in the blow
    Mobility partner;
};

/// Cosine of the angle below which contacts of a partner push alike.
constexpr double push_alike = 0.9;

/// The foundations of a struck body: contacts of one partner that push alike are one. Its part of the true
/// surface is what lies at the contacts' depth within their convex hull, for Bullet keeps four points of a
/// flat contact. The bed is stiffest below the strike, as the pressure below a layer that carries a point
/// load, (1 + r^2 / h^2)^(-5/2) at a distance r from the load's axis and h below it (Boussinesq; Johnson
/// 1985, 3.2): a thick body presses on all of it, a thin plate only under the blow. The springs together are
/// as stiff as a rigid disc of their area on a half-space, 2 E* a (Johnson 1985, 3.4). In a heap the 16 that
/// carry most stand for all. Of a body that is squeezed the beds on all sides count, with the load where the
/// other body is struck.
std::vector<Foundation> foundationsOf(const ContactBody& body, const Blow& blow, const Strike& strike,
                                      const ContactSettings& settings);

}  // namespace sherd
