#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>
#include <sherd/triangle_mesh.h>

#include <vector>

#include "core/loads/blow.h"

namespace sherd {

/// What the loads need to know of the struck body.
struct ContactBody {
    const TriangleMesh& surface;
    const Material& material;
    double wall_thickness_m = 0;
    double radius_m = 0;  ///< of the sphere about its centre that holds it
};

/// A blow as tractions of 1 N in total (the sum of the normal forces), and what scales them.
struct ContactLoads {
    std::vector<PointForce> unit;
    double mass_kg = 0;        ///< stopped by all contacts
    double speed_m_s = 0;      ///< the closing speed at which that mass carries the blow's energy
    double hertz_force_n = 0;  ///< peak force if the body were rigid but for the contact: an upper bound
};

/// Spreads each contact over its Hertz patch on the true surface, in proportion to the impulses. The radius
/// of curvature is read off the surface and the partner, and kept between a fraction of the wall and the
/// body's own radius (flat on flat).
ContactLoads contactLoads(const ContactBody& body, const Blow& blow, const ContactSettings& settings);

/// Where forces act on the whole, their places weighted with their size, and the direction of their sum.
BlowAxis axisOf(const std::vector<PointForce>& forces);

}  // namespace sherd
