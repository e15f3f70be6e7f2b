#include "core/loads/contact_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "core/loads/near_remainder.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// Parts of a patch that lie on one smooth face.
struct Facet {
    Vec3 outward = Vec3::Zero();
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;  // along it
    double pressed = 1;                                                          ///< see PatchPart
};

/// The normals of a patch's parts, one for each of those that are nearly alike: of however many triangles
/// the patch is made, these are few.
struct AlikeNormals {
    explicit AlikeNormals(const std::vector<PatchPart>& parts) {
        std::map<RoundedNormal, int> found;
        for (const PatchPart& part : parts) {
            const auto place =
                found.try_emplace(rounded(part.normal), static_cast<int>(normals.size())).first;
            if (place->second == static_cast<int>(normals.size())) normals.push_back(part.normal);
            of_part.push_back(place->second);
        }
    }
    std::vector<Vec3> normals;
    std::vector<int> of_part;  ///< numbers of normals
};

/// Splits normals where they turn at once: what turns little by little is one face. Returns their numbers.
std::vector<std::vector<int>> faces(const std::vector<Vec3>& normals) {
    std::vector<int> left(normals.size());
    std::iota(left.begin(), left.end(), 0);
    std::vector<std::vector<int>> found;
    while (!left.empty()) {
        std::vector<int> own{left.front()};
        left.erase(left.begin());
        for (std::size_t i = 0; i < own.size(); ++i) {
            const Vec3& normal = normals[own[i]];
            const auto others = std::partition(left.begin(), left.end(), [&](int other) {
                return normals[other].dot(normal) < on_one_face;
            });
            own.insert(own.end(), others, left.end());
            left.erase(others, left.end());
        }
        found.push_back(std::move(own));
    }
    return found;
}

/// None if there are more than `most`.
std::vector<Facet> facetsOf(const std::vector<PatchPart>& parts, std::size_t most) {
    const AlikeNormals alike(parts);
    const std::vector<std::vector<int>> found = faces(alike.normals);
    if (found.size() > most) return {};
    std::vector<Facet> facets;
    for (const std::vector<int>& own : found) {
        std::vector<char> is_own(alike.normals.size(), 0);
        for (const int n : own) is_own[n] = 1;
        std::vector<const PatchPart*> on_it;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            // Most parts are told by the normal that stands for theirs.
            const bool is_on = is_own[alike.of_part[i]] || std::any_of(own.begin(), own.end(), [&](int n) {
                                   return alike.normals[n].dot(parts[i].normal) >= on_one_face;
                               });
            if (is_on) on_it.push_back(&parts[i]);
        }
        Facet facet;
        double weight = 0, of_most = 0;
        for (const PatchPart* part : on_it) {
            facet.outward += part->weight_m2 * part->normal;
            weight += part->weight_m2;
            of_most += part->weight_m2 / part->pressed;
        }
        facet.outward.normalize();
        facet.pressed = weight / of_most;
        for (const PatchPart* part : on_it) {
            const double height = part->centre.dot(facet.outward);
            facet.lowest = std::min(facet.lowest, height);
            facet.highest = std::max(facet.highest, height);
        }
        facets.push_back(facet);
    }
    return facets;
}

/// Whether faces of a patch meet in a hollow, so that a part of one lies before another. A disc on the plane
/// of one would then stand for what presses deep inside the body.
bool meetInAHollow(const std::vector<Facet>& facets, const ContactPatch& patch) {
    constexpr double flat = 0.02;  // of the radius
    return std::any_of(facets.begin(), facets.end(), [&](const Facet& facet) {
        return std::any_of(patch.parts.begin(), patch.parts.end(), [&](const PatchPart& part) {
            return part.centre.dot(facet.outward) > facet.highest + flat * patch.radius_m;
        });
    });
}

/// How the surface lies about a disc.
enum class Lie { behind, hollow, overhung };

/// A hollow surface rises above the disc's plane, slowly or as a wall beside it, and the near field goes on
/// there. It means nothing across air. What is further away is the grid's anyway.
Lie lieOf(const SurfaceTree& surface, const ContactDisc& disc) {
    constexpr double reach = 2.5;        // radii
    constexpr double flat = 0.02;        // of the radius
    constexpr double facing_back = 0.2;  // cosine
    Lie lie = Lie::behind;
    for (const PieceNearby& piece :
         surfaceAround(surface, disc.centre, reach * disc.radius, disc.radius, 0.5 * disc.radius)) {
        const Vec3 offset = piece.centre - disc.centre;
        if (offset.norm() > reach * disc.radius || -offset.dot(disc.inward) < flat * disc.radius) continue;
        const bool faces_disc = piece.area.dot(offset) < 0;  // not so the back of a wall beside it
        if (faces_disc && piece.area.dot(disc.inward) > facing_back * piece.area.norm()) return Lie::overhung;
        lie = Lie::hollow;
    }
    return lie;
}

/// Places under a patch, as close as its tension may change on a round surface.
void addParts(const ContactPatch& patch, std::vector<SurfacePlace>& places) {
    constexpr double length = 0.12;  // of a cube, in radii
    constexpr double facing = 2;     // steps of a normal's component
    std::set<std::array<long, 6>> taken;
    for (const PatchPart& part : patch.parts) {
        std::array<long, 6> cube;
        for (int d = 0; d < 3; ++d) {
            cube[d] = std::lround((part.centre[d] - patch.spot.point[d]) / (length * patch.radius_m));
            cube[3 + d] = std::lround(facing * part.normal[d]);
        }
        if (taken.insert(cube).second) places.push_back({part.centre, part.normal});
    }
}

/// The disc opposite another one, and the number of its place.
struct Opposite {
    ContactDisc disc;
    std::size_t place = 0;
};

/// Adds the place opposite a disc, if there is one: there a thin wall is bent most.
std::optional<Opposite> addOpposite(const SurfaceTree& tree, const ContactDisc& disc,
                                    std::vector<SurfacePlace>& places) {
    const SurfaceSpot spot = wayOut(tree, disc.centre + 1e-3 * disc.radius * disc.inward, disc.inward);
    if (spot.triangle < 0) return {};
    places.push_back({spot.point, areaVector(cornersOf(tree.surface(), spot.triangle)).normalized()});
    return Opposite{oppositeOf(disc, spot.point), places.size() - 1};
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
            if (normal.dot(disc.inward) >= -least_facing) continue;
            places.push_back({spot.point, normal});
        }
}

/// Adds what the near field leaves close to its discs, and at the places what the grid misses of that and of
/// what it leaves opposite the discs.
void addRemainder(const SurfaceTree& surface, const std::vector<std::optional<Opposite>>& opposites,
                  const RemainderGrid& grid, ContactField& field) {
    constexpr double thin = 1.5, thick = 2.5;  // spacings: the grid knows what thick walls do
    struct Part {
        std::vector<RemainderPiece> close;
        std::vector<SymmetricTensor> missed;  ///< at all places
    };
    std::vector<Part> parts(opposites.size());
    forEachChunk(static_cast<int>(parts.size()), [&](int i) {
        Part& part = parts[i];
        part.close = closeRemainder(surface, field.near, i);
        part.missed = unresolvedAt(field.places, part.close, field.near.discs()[i], grid);
        if (!opposites[i]) return;
        const auto [disc, place] = *opposites[i];
        const double share = std::clamp((thick - disc.radius / grid.spacing_m) / (thick - thin), 0.0, 1.0);
        if (share > 0)
            part.missed[place] +=
                share *
                unresolvedAt({field.places[place]}, oppositeRemainder(surface, field.near, disc), disc, grid)
                    .front();
    });
    for (const Part& part : parts) {
        for (const RemainderPiece& piece : part.close) field.close.push_back({piece.centre, piece.force});
        for (std::size_t i = 0; i < field.places.size(); ++i) field.places[i].unresolved += part.missed[i];
    }
}

/// Which patches are to have a near field, the hardest ones: each disc's field is added to that of all
/// others. Where one presses a body to pieces, those do nothing that press fifty times less.
std::vector<char> hardestOf(const std::vector<ContactPatch>& patches) {
    constexpr std::size_t most = 8;
    constexpr double faint = 0.02;  // of the largest traction
    std::vector<std::size_t> order(patches.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return patches[a].force.squaredNorm() > patches[b].force.squaredNorm();
    });
    const auto traction = [](const ContactPatch& patch) {
        return patch.force.norm() / (patch.radius_m * patch.radius_m);
    };
    order.resize(std::min(most, order.size()));
    double largest = 0;
    for (const std::size_t i : order) largest = std::max(largest, traction(patches[i]));
    std::vector<char> hardest(patches.size(), 0);
    for (const std::size_t i : order) hardest[i] = traction(patches[i]) >= faint * largest;
    return hardest;
}

}  // namespace

std::vector<ContactDisc> contactDiscs(const SurfaceTree& surface, const ContactPatch& patch) {
    constexpr std::size_t most_facets = 2;  // at corners the grid is nearer to the truth
    double weight = 0;
    for (const PatchPart& part : patch.parts) weight += part.weight_m2;
    if (!(weight > 0)) return {};
    const std::vector<Facet> facets = facetsOf(patch.parts, most_facets);
    if (meetInAHollow(facets, patch)) return {};
    const double whole = 0.4 * pi * patch.radius_m * patch.radius_m;  // of a disc that lies on a plane
    std::vector<ContactDisc> discs;
    for (const Facet& facet : facets) {
        const double spot = patch.spot.point.dot(facet.outward);
        const double above = std::clamp(spot, facet.lowest, facet.highest) - spot;
        const double squared = patch.radius_m * patch.radius_m - above * above;
        if (facet.highest - facet.lowest > largest_sag * patch.radius_m || !(squared > 0)) return {};
        // On a plane that cuts the sphere about the spot off its middle the traction is that of a smaller
        // disc.
        const double in_middle = contactProfile(above * above / (patch.radius_m * patch.radius_m));
        ContactDisc disc{patch.spot.point + above * facet.outward, -facet.outward, std::sqrt(squared),
                         facet.pressed * in_middle / weight * patch.force};
        const Lie lie = lieOf(surface, disc);
        if (lie == Lie::overhung) return {};
        disc.hollow = lie == Lie::hollow;
        if (weight < (disc.hollow ? least_share_in_hollow : least_share) * whole) return {};
        discs.push_back(disc);
    }
    return discs;
}

ContactField contactField(const ContactBody& body, const std::vector<ContactPatch>& patches,
                          double spacing_m) {
    const std::vector<char> hardest = hardestOf(patches);
    ContactField field;
    std::vector<ContactDisc> discs;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const ContactPatch& patch = patches[i];
        const auto own = hardest[i] ? contactDiscs(body.surface, patch) : std::vector<ContactDisc>();
        discs.insert(discs.end(), own.begin(), own.end());
        if (!own.empty()) {
            addParts(patch, field.places);
            continue;
        }
        const auto forces = spreadForce(patch.parts, patch.spot, patch.force);
        field.others.insert(field.others.end(), forces.begin(), forces.end());
    }
    field.near = NearField(discs, body.material.poisson_ratio);
    for (const ContactDisc& disc : discs) addRim(body.surface, disc, field.places);
    std::vector<std::optional<Opposite>> opposites;
    for (const ContactDisc& disc : discs) opposites.push_back(addOpposite(body.surface, disc, field.places));
    addRemainder(body.surface, opposites, {spacing_m, body.material.poisson_ratio}, field);
    return field;
}

}  // namespace sherd
