#include "core/loads/contact_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

constexpr double alike = 0.95;          // cosine between the normals of one plane, of its first part's
constexpr double largest_bulge = 0.05;  // of the radius: how far the body may rise above the plane

/// Parts of a patch that lie on one plane.
struct Facet {
    Vec3 outward = Vec3::Zero();
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;  ///< along it
};

/// Splits the parts by their normals, beginning with the one that is pressed most.
std::vector<Facet> facetsOf(std::vector<PatchPart> parts) {
    std::vector<Facet> facets;
    while (!parts.empty()) {
        const Vec3 first = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
                               return a.weight_m2 < b.weight_m2;
                           })->normal;
        const auto others = std::partition(parts.begin(), parts.end(), [&](const PatchPart& part) {
            return part.normal.dot(first) >= alike;
        });
        Facet facet;
        for (auto part = parts.begin(); part != others; ++part)
            facet.outward += part->weight_m2 * part->normal;
        facet.outward.normalize();
        for (auto part = parts.begin(); part != others; ++part) {
            const double height = part->centre.dot(facet.outward);
            facet.lowest = std::min(facet.lowest, height);
            facet.highest = std::max(facet.highest, height);
        }
        facets.push_back(facet);
        parts.erase(parts.begin(), others);
    }
    return facets;
}

bool isBehind(const TriangleMesh& surface, const ContactDisc& disc) {
    const double highest = disc.inward.dot(disc.centre) - largest_bulge * disc.radius;
    return std::all_of(surface.vertices.begin(), surface.vertices.end(),
                       [&](const Vec3& v) { return v.dot(disc.inward) >= highest; });
}

/// Places where friction is small and the surface is pulled most round a disc, as far as they are on it.
void addRim(const SurfaceTree& tree, const ContactDisc& disc, std::vector<SurfacePlace>& places) {
    constexpr int angles = 20;
    const Vec3 slide = disc.traction_pa - disc.inward * disc.inward.dot(disc.traction_pa);
    const Vec3 a = slide.norm() > 0 ? Vec3(-slide.normalized()) : Vec3(disc.inward.unitOrthogonal());
    const Vec3 b = disc.inward.cross(a);
    for (const double share : {0.9, 1.0})
        for (int i = 0; i < angles; ++i) {
            const double angle = 2 * pi * i / angles;
            const Vec3 x = disc.centre + share * disc.radius * (std::cos(angle) * a + std::sin(angle) * b);
            const SurfaceSpot spot = nearestSurfacePoint(tree, x, disc.inward);
            if (spot.triangle < 0 || (spot.point - x).norm() > largest_sag * disc.radius) continue;
            const Vec3 normal = areaVector(cornersOf(tree.surface(), spot.triangle)).normalized();
            if (normal.dot(disc.inward) < -least_facing) places.push_back({spot.point, normal});
        }
}

}  // namespace

std::vector<ContactDisc> contactDiscs(const SurfaceTree& surface, const ContactPatch& patch) {
    constexpr std::size_t most_facets = 2;  // at corners the grid is nearer to the truth
    double weight = 0;
    for (const PatchPart& part : patch.parts) weight += part.weight_m2;
    if (!(weight > 0)) return {};
    std::vector<ContactDisc> discs;
    for (const Facet& facet : facetsOf(patch.parts)) {
        const double above = facet.highest - patch.spot.point.dot(facet.outward);
        const double squared = patch.radius_m * patch.radius_m - above * above;
        if (facet.highest - facet.lowest > largest_sag * patch.radius_m || !(squared > 0)) return {};
        // On a plane that cuts the sphere about the spot off its middle the traction is that of a smaller
        // disc.
        const double in_middle = contactProfile(above * above / (patch.radius_m * patch.radius_m));
        ContactDisc disc{patch.spot.point + above * facet.outward, -facet.outward, std::sqrt(squared),
                         in_middle / weight * patch.force};
        if (!isBehind(surface.surface(), disc) || discs.size() == most_facets) return {};
        discs.push_back(disc);
    }
    return discs;
}

ContactField contactField(const ContactBody& body, const std::vector<ContactPatch>& patches) {
    ContactField field;
    std::vector<ContactDisc> discs;
    for (const ContactPatch& patch : patches) {
        const std::vector<ContactDisc> own = contactDiscs(body.surface, patch);
        discs.insert(discs.end(), own.begin(), own.end());
        if (!own.empty()) {
            for (const PatchPart& part : patch.parts) field.places.push_back({part.centre, part.normal});
            continue;
        }
        const auto forces = spreadForce(patch.parts, patch.spot, patch.force);
        field.others.insert(field.others.end(), forces.begin(), forces.end());
    }
    for (const ContactDisc& disc : discs) addRim(body.surface, disc, field.places);
    field.near = NearField(discs, body.material.poisson_ratio);
    return field;
}

}  // namespace sherd
