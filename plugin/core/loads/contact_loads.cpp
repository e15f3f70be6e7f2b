#include "core/loads/contact_loads.h"

#include <algorithm>
#include <cmath>

#include "core/loads/contact_pulse.h"
#include "core/loads/load_patch.h"

namespace sherd {

namespace {

// Height of the cap from which the radius of curvature is read, and how far round the contact it is looked
// for, in wall thicknesses. Low enough to tell an edge from a face, high enough to see past the facets of a
// tessellated surface.
constexpr double cap_height = 0.02;
constexpr double cap_reach = 1.0;

HertzContact hertzContact(const ContactBody& body, const ContactImpulse& contact, const SurfaceSpot& spot,
                          const ContactSettings& settings) {
    const double wall = body.wall_thickness_m;
    const double own =
        contactRadius(body.surface, spot.point, contact.normal, cap_reach * wall, cap_height * wall);
    const double curvature =
        (own > 0 ? 1 / own : 0) + (contact.partner_radius_m > 0 ? 1 / contact.partner_radius_m : 0);
    const bool known = contact.partner_youngs_modulus_pa > 0;
    HertzContact hertz;
    hertz.radius_m = std::clamp(curvature > 0 ? 1 / curvature : body.radius_m, settings.smallest_patch * wall,
                                std::max(body.radius_m, settings.smallest_patch * wall));
    hertz.contact_modulus_pa =
        contactModulus(body.material.youngs_modulus_pa, body.material.poisson_ratio,
                       known ? contact.partner_youngs_modulus_pa : settings.partner_youngs_modulus_pa,
                       known ? contact.partner_poisson_ratio : settings.partner_poisson_ratio);
    return hertz;
}

}  // namespace

ContactLoads contactLoads(const ContactBody& body, const Blow& blow, const ContactSettings& settings) {
    ContactLoads loads;
    const double pushed = normalImpulse(blow);
    double energy = 0;
    if (!(pushed > 0)) return loads;
    const double smallest = settings.smallest_patch * body.wall_thickness_m;
    const double largest = std::max(smallest, settings.largest_patch * body.radius_m);
    for (const ContactImpulse& contact : blow.contacts) {
        if (!(contact.impulse.dot(contact.normal) > 0)) continue;
        const SurfaceSpot spot = nearestSurfacePoint(body.surface, contact.point, contact.normal);
        HertzContact hertz = hertzContact(body, contact, spot, settings);
        const ContactShare share = contactShare(contact);
        const double given = contact.patch_radius_m > 0 ? std::max(contact.patch_radius_m, smallest) : 0;
        if (given > 0 && share.energy_j > 0)
            hertz.radius_m = hertzRadiusOfPatch(hertz.contact_modulus_pa, given, share.energy_j);
        const double peak = share.energy_j > 0 ? hertzPeakForce(hertz, share.mass_kg, share.speed_m_s) : 0;
        const double patch = given > 0 ? given : std::clamp(hertzPatchRadius(hertz, peak), smallest, largest);
        const auto forces = spreadForce(body.surface, spot, contact.normal, patch, contact.impulse / pushed);
        loads.unit.insert(loads.unit.end(), forces.begin(), forces.end());
        loads.hertz_force_n += peak;
        loads.mass_kg += share.mass_kg;
        energy += share.energy_j;
    }
    if (energy > 0) loads.speed_m_s = std::sqrt(2 * energy / loads.mass_kg);
    return loads;
}

BlowAxis axisOf(const std::vector<PointForce>& forces) {
    Vec3 places = Vec3::Zero(), sum = Vec3::Zero();
    double weight = 0;
    for (const PointForce& force : forces) {
        places += force.force.norm() * force.position;
        sum += force.force;
        weight += force.force.norm();
    }
    if (!(weight > 0)) return {};
    constexpr double least = 1e-6;  // of all forces: below that they pull apart and have no direction
    return {places / weight, sum.norm() > least * weight ? sum.normalized().eval() : Vec3(Vec3::Zero())};
}

}  // namespace sherd
