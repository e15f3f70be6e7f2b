#include "core/loads/contact_loads.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/loads/landed_faces.h"

namespace sherd {

namespace {

// Height of the cap from which the radius of curvature is read, and how far round the contact it is looked
// for, in wall thicknesses. Low enough to tell an edge from a face, high enough to see past the facets of a
// tessellated surface.
constexpr double cap_height = 0.02;
constexpr double cap_reach = 1.0;

constexpr double touching = 0.1;  // of the wall: how far a surface may be from what touches it

/// Where on the surface of a body a contact is. A shape that stands for the body in collisions may close its
/// hollows: what is flat then touches the rim, not the hollow's bottom.
SurfaceSpot spotOf(const SurfaceTree& surface, double wall, const Vec3& point, const Vec3& push,
                   bool other_is_round) {
    const SurfaceSpot nearest = nearestSurfacePoint(surface, point, push);
    const double gap = touching * wall;
    const bool is_recessed = (nearest.point - point).dot(push) > gap;
    if (!is_recessed || other_is_round) return nearest;
    const SurfaceSpot rim = touchedByAPlane(surface, point, push, gap);
    return rim.triangle < 0 ? nearest : rim;
}

/// 1/m.
double curvatureAt(const SurfaceTree& surface, double wall, const SurfaceSpot& spot, const Vec3& push) {
    const double radius = contactRadius(surface, spot.point, push, cap_reach * wall, cap_height * wall);
    return radius > 0 ? 1 / radius : 0;
}

/// 1/m; 0 where it is not known.
double partnerCurvature(const ContactImpulse& contact) {
    if (contact.partner_radius_m > 0) return 1 / contact.partner_radius_m;
    if (!contact.partner_surface) return 0;
    const TouchingSurface& own = *contact.partner_surface;
    const SurfaceSpot spot = spotOf(*own.surface, own.wall_thickness_m, own.point, own.push, false);
    return curvatureAt(*own.surface, own.wall_thickness_m, spot, own.push);
}

StrikePoint strikePoint(const ContactBody& body, const ContactImpulse& contact,
                        const ContactSettings& settings) {
    const double wall = body.wall_thickness_m;
    const SurfaceSpot spot =
        spotOf(body.surface, wall, contact.point, contact.normal, contact.partner_radius_m > 0);
    const double curvature =
        curvatureAt(body.surface, wall, spot, contact.normal) + partnerCurvature(contact);
    HertzContact hertz;
    hertz.radius_m = std::clamp(curvature > 0 ? 1 / curvature : body.radius_m, settings.smallest_patch * wall,
                                std::max(body.radius_m, settings.smallest_patch * wall));
    hertz.contact_modulus_pa = contactModulus(body, contact, settings);
    StrikePoint found;
    found.contact = &contact;
    found.spot = spot;
    found.hertz = hertz;
    found.share = 1;
    found.push = contact.normal;
    return found;
}

/// The striking contacts, those that were met at about the same time as the leading one first, without those
/// that share a patch with one of their partner before them: boxes side by side give the same point twice.
std::vector<const ContactImpulse*> separateContacts(const ContactBody& body, const Blow& blow,
                                                    const ContactImpulse& leading,
                                                    const ContactSettings& settings) {
    std::vector<const ContactImpulse*> met = blow.strikes(), separate;
    const auto apart_s = [&](const ContactImpulse* contact) {
        return contact == &leading ? -1 : std::abs(contact->touched_s - leading.touched_s);
    };
    std::stable_sort(met.begin(), met.end(), [&](const ContactImpulse* a, const ContactImpulse* b) {
        return apart_s(a) < apart_s(b);
    });
    const double patch = settings.smallest_patch * body.wall_thickness_m;
    for (const ContactImpulse* contact : met) {
        const auto shared = [&](const ContactImpulse* other) {
            return contact->partner == other->partner && (contact->point - other->point).norm() < patch &&
                   contact->normal.dot(other->normal) > alike_normals;
        };
        if (std::none_of(separate.begin(), separate.end(), shared)) separate.push_back(contact);
    }
    return separate;
}

/// Of the patch that the app gives, no larger than the body; 0: it gives none.
double givenRadius(const ContactBody& body, const ContactImpulse& contact, const ContactSettings& settings) {
    const double smallest = settings.smallest_patch * body.wall_thickness_m;
    const double given = contact.patch_radius_m;
    return given > 0 ? std::clamp(given, smallest, std::max(smallest, body.radius_m)) : 0;
}

/// A patch that the app gives is that of a contact of its size: it takes up as much of the energy.
void giveCurvature(const ContactBody& body, const ContactSettings& settings, Strike& strike) {
    for (StrikePoint& point : strike.points) {
        const double given = givenRadius(body, *point.contact, settings);
        const double energy = 0.5 * point.share * strike.mass(0) * strike.speed_m_s * strike.speed_m_s;
        if (given > 0 && energy > 0)
            point.hertz.radius_m = hertzRadiusOfPatch(point.hertz.contact_modulus_pa, given, energy);
    }
}

}  // namespace

double contactModulus(const ContactBody& body, const ContactImpulse& contact,
                      const ContactSettings& settings) {
    const bool known = contact.partner_youngs_modulus_pa > 0;
    return contactModulus(body.material.youngs_modulus_pa, body.material.poisson_ratio,
                          known ? contact.partner_youngs_modulus_pa : settings.partner_youngs_modulus_pa,
                          known ? contact.partner_poisson_ratio : settings.partner_poisson_ratio);
}

Strike strikeOf(const ContactBody& body, const Blow& blow, const ContactSettings& settings) {
    Strike strike;
    const ContactImpulse* leading = leadingTouch(blow, body.mobility.mass());
    if (!leading) return strike;
    const StrikePoint leading_point = strikePoint(body, *leading, settings);
    strike.points = {leading_point};
    shareOut(body.mobility, blow, strike);
    const double duration = strike.hertzDuration();

    strike.points.clear();
    for (const ContactImpulse* contact : separateContacts(body, blow, *leading, settings)) {
        const double present = presence(leading->touched_s - contact->touched_s, duration);
        if (!(present > 0)) break;
        strike.points.push_back(contact == leading ? leading_point : strikePoint(body, *contact, settings));
        strike.points.back().share = present;
    }
    shareOut(body.mobility, blow, strike);
    giveCurvature(body, settings, strike);
    spreadOverFaces(body, strike);
    return strike;
}

Impact impactOf(const Strike& strike, double held) {
    if (!strike.strikes()) return {};
    return {strike.mass(held), strike.speed_m_s, strike.hertzForce(held)};
}

double patchRadius(const ContactBody& body, const Strike& strike, const StrikePoint& point,
                   const ContactSettings& settings) {
    const double smallest = settings.smallest_patch * body.wall_thickness_m;
    const double largest = std::max(smallest, settings.largest_patch * body.radius_m);
    if (const double given = givenRadius(body, *point.contact, settings); given > 0) return given;
    const double peak = hertzPeakForce(point.hertz, point.share * strike.mass(0), strike.speed_m_s);
    return std::max(std::clamp(hertzPatchRadius(point.hertz, peak), smallest, largest), point.on_face_m);
}

double patchEnergy(const ContactBody& body, const Strike& strike, const ContactSettings& settings,
                   double spacing_m) {
    constexpr double sharpest = 0.5;  // of a spacing: what is smaller looks like that on the grid
    const Material& m = body.material;
    const double compliance = 5 * (1 - m.poisson_ratio * m.poisson_ratio) / (7 * m.youngs_modulus_pa);
    double energy = 0;
    for (const StrikePoint& point : strike.points) {
        const double radius = std::max(patchRadius(body, strike, point, settings), sharpest * spacing_m);
        energy += 0.5 * compliance * point.share * point.share / radius;
    }
    return energy;
}

std::vector<ContactPatch> contactPatches(const ContactBody& body, const Strike& strike,
                                         const ContactSettings& settings) {
    constexpr double few = 4, fine = 0.18, coarse = 0.5;  // patches; lengths of parts in radii
    const double count = static_cast<double>(strike.points.size());
    const double length = std::clamp(fine * std::sqrt(count / few), fine, coarse);
    std::vector<ContactPatch> patches;
    for (const StrikePoint& point : strike.points) {
        if (!(point.share > 0)) continue;
        ContactPatch patch{point.spot,
                           point.contact->normal,
                           point.share * point.push,
                           patchRadius(body, strike, point, settings),
                           {}};
        patch.parts = partsOfPatch(body.surface, patch.spot, patch.push, patch.radius_m, length);
        if (point.face && patch.radius_m <= point.on_face_m) keepWhatTouches(point, patch.parts);
        patches.push_back(std::move(patch));
    }
    return patches;
}

std::vector<PointForce> unitLoads(const std::vector<ContactPatch>& patches) {
    std::vector<PointForce> loads;
    for (const ContactPatch& patch : patches) {
        const auto forces = spreadForce(patch.parts, patch.spot, patch.force);
        loads.insert(loads.end(), forces.begin(), forces.end());
    }
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
    BlowAxis axis;
    axis.contact = places / weight;
    if (sum.norm() > least * weight) axis.direction = sum.normalized();
    double squares = 0;
    for (const PointForce& force : forces)
        squares += force.force.norm() * (force.position - axis.contact).squaredNorm();
    axis.radius_m = std::sqrt(squares / weight);
    return axis;
}

}  // namespace sherd
