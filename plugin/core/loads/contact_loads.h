#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>

#include <vector>

#include "core/loads/blow.h"
#include "core/loads/contact_pulse.h"
#include "core/loads/load_patch.h"
#include "core/loads/mobility.h"
#include "core/loads/strike.h"

namespace sherd {

/// Cosine of the angle between the normals of contacts that share a patch or a face.
constexpr double alike_normals = 0.9;

/// What the loads need to know of the struck body.
struct ContactBody {
    const SurfaceTree& surface;
    const Material& material;
    Mobility mobility;
    double wall_thickness_m = 0;
    double radius_m = 0;  ///< of the sphere about its centre that holds it
};

/// What strikes a body. What carries its weight or answers the strike elsewhere is no part of it (see
/// Foundation). The radius of curvature is read off the surface and the partner, and kept between a fraction
/// of the wall and the body's own radius (flat on flat). Of all contacts those count that have met by the
/// time at which the leading one presses hardest, whoever they are of: how far bodies overlap, and so how
/// many contacts there are, is a matter of the time step, not of the blow; and a floor of four bodies stops
/// what falls on their seam once, as one would. Refers to the contacts of `blow`.
Strike strikeOf(const ContactBody& body, const Blow& blow, const ContactSettings& settings);

/// Of a strike, with supports that take the share `held` of the body's mobility away.
Impact impactOf(const Strike& strike, double held);

/// Radius of the disc over which a strike's force at one of its points is spread, m.
double patchRadius(const ContactBody& body, const Strike& strike, const StrikePoint& point,
                   const ContactSettings& settings);

/// Strain energy that the patches of a strike store about themselves at 1 N in total, J. Under a traction
/// that falls off as (1 - (r/a)^2)^(3/2) a half-space gives way by 5 (1 - nu^2) F / (7 E a) in the mean,
/// weighted with the traction (the Hankel transform of Johnson 1985, 3.4). A Hertz contact gives way by that,
/// too: what a grid of that spacing stores there is counted twice.
double patchEnergy(const ContactBody& body, const Strike& strike, const ContactSettings& settings,
                   double spacing_m);

/// The part of the surface that a point of a strike presses on, and how strongly.
struct ContactPatch {
    SurfaceSpot spot;
    Vec3 push = Vec3::Zero();   ///< unit: faces that it does not meet are not pressed
    Vec3 force = Vec3::Zero();  ///< N
    double radius_m = 0;
    std::vector<PatchPart> parts;
};

/// A strike as tractions of 1 N in total (the sum of the normal forces), each point spread over its Hertz
/// patch on the true surface.
std::vector<ContactPatch> contactPatches(const ContactBody& body, const Strike& strike,
                                         const ContactSettings& settings);

/// Their quadrature points.
std::vector<PointForce> unitLoads(const std::vector<ContactPatch>& patches);

/// The modulus of a contact; the settings stand in for what is not known of the partner.
double contactModulus(const ContactBody& body, const ContactImpulse& contact,
                      const ContactSettings& settings);

/// Where forces act on the whole, their places weighted with their size, how far around that they act, and
/// the direction of their sum.
BlowAxis axisOf(const std::vector<PointForce>& forces);

}  // namespace sherd
