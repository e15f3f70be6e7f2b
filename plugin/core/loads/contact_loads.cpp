#include "core/loads/contact_loads.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/numerics/pi.h"
#include "core/numerics/union_find.h"

namespace sherd {

namespace {

// Height of the cap from which the radius of curvature is read, and how far round the contact it is looked
// for, in wall thicknesses. Low enough to tell an edge from a face, high enough to see past the facets of a
// tessellated surface.
constexpr double cap_height = 0.02;
constexpr double cap_reach = 1.0;

constexpr double touching = 0.1;  // of the wall: how far a surface may be from what touches it

constexpr double alike = 0.9;  // cosine of the angle between normals of one patch

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
                   contact->normal.dot(other->normal) > alike;
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

constexpr double level = 1e-3;  // of the way between two corners: how deep a face may lie that touches

/// Whether the surface between two points of a strike is a face that lies on the same flat partner.
bool areOnOneFace(const ContactBody& body, const StrikePoint& a, const StrikePoint& b) {
    constexpr double beside = 0.02;  // of the way between them
    const Vec3& push = a.contact->normal;
    if (a.contact->partner != b.contact->partner || push.dot(b.contact->normal) < alike) return false;
    const Vec3 middle = (a.spot.point + b.spot.point) / 2;
    const Vec3 off = nearestSurfacePoint(body.surface, middle, push).point - middle;
    const double way = (a.spot.point - b.spot.point).norm();
    return off.norm() < beside * way && std::abs(off.dot(push)) < level * way;
}

/// How wide the contact of a face is across its narrow side, m: half of a rectangle's width if its corners
/// press alike, and nothing if those on one edge do alone.
double narrowSide(const std::vector<const StrikePoint*>& corners) {
    Vec3 middle = Vec3::Zero();
    double all = 0;
    for (const StrikePoint* corner : corners) {
        middle += corner->share * corner->spot.point;
        all += corner->share;
    }
    middle /= all;
    Mat3 spread = Mat3::Zero();
    for (const StrikePoint* corner : corners) {
        const Vec3 off = corner->spot.point - middle;
        spread += corner->share / all * off * off.transpose();
    }
    const Vec3 squares = Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues();
    return std::sqrt(std::max(0.0, squares[1]));
}

/// Whether a face of the body ends at its outermost points of contact, `way` apart: these are its own corners
/// then, and else those of what strikes it there.
bool endsWithItsCorners(const ContactBody& body, const std::vector<Vec3>& corners, const Footprint& face,
                        double way) {
    constexpr double further = 0.1;  // of the way between two corners
    constexpr double flush = 0.03;   // of that
    const Vec3 middle = std::accumulate(corners.begin(), corners.end(), Vec3(Vec3::Zero())) /
                        static_cast<double>(corners.size());
    const double probe = further * way;
    return std::none_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
        const Vec3 to = corner - middle, along = to - face.push() * face.push().dot(to);
        if (!(along.norm() > 0)) return false;
        const Vec3 beyond = corner + probe * along.normalized();
        const Vec3 off = nearestSurfacePoint(body.surface, beyond, face.push()).point - beyond;
        return face.outside(beyond) > flush * probe && off.norm() < flush * probe;
    });
}

/// A part of a face that a blow presses against a flat partner, and how deep.
struct PressedPart {
    double radius_m = 0, depth_m = 0;
};

/// The part about a corner of a face that is tilted by little. A force F on a disc of radius r dents a
/// half-space by F / (2 E* r), and what ends at an edge by as much more as less of the disc lies on it; what
/// is nearer to the partner than that touches. Where that is half of what lies within r, the contact's own
/// radius is r / 1.4: so it is of a paraboloid (Hertz) and of a blunt cone (Sneddon 1965). `most_m`: what is
/// the corner's. Radius 0: no more than Hertz's is pressed, or the face is level; where its far edge does not
/// touch then, what it lies on ends before it.
PressedPart pressedAbout(const ContactBody& body, const StrikePoint& corner, double force_n, double most_m) {
    constexpr double wider = 1.4, least = 0.07, step = 0.93, least_on_it = 0.25;
    constexpr double close = 0.3, size = 0.05;  // of the reach
    constexpr double hardly = 1e-4;             // sine of a tilt
    struct Near {
        double distance, gap, area;
    };
    std::vector<Near> around;
    bool is_level = true;
    const Vec3& push = corner.contact->normal;
    const double reach = wider * most_m;
    for (const PieceNearby& piece :
         surfaceAround(body.surface, corner.spot.point, reach, close * reach, size * reach)) {
        const Vec3 way = piece.centre - corner.spot.point;
        const double facing = -piece.area.dot(push);
        if (!(facing > 0.5 * piece.area.norm())) continue;
        around.push_back({way.norm(), way.dot(push), facing});
        is_level = is_level && piece.area.cross(push).norm() < hardly * facing;
    }
    if (is_level) return {};
    for (double radius = reach; radius > wider * least * most_m; radius *= step) {
        double all = 0, touching_area = 0;
        for (const Near& part : around)
            if (part.distance < radius) all += part.area;
        const double on_it = std::clamp(all / (pi * radius * radius), least_on_it, 1.0);
        const double depth = force_n / (2 * corner.hertz.contact_modulus_pa * radius * on_it);
        for (const Near& part : around)
            if (part.distance < radius && part.gap < depth) touching_area += part.area;
        if (touching_area > 0.5 * all) return {radius / wider, depth};
    }
    const double smaller = 2 * least * most_m;
    if (!(smaller > hertzPatchRadius(corner.hertz, force_n))) return {};
    return pressedAbout(body, corner, force_n, smaller);
}

/// Corners of a face that lands flat stand for all of it: each presses on the part that is nearer to it than
/// to the next ones, as far as the face touches. What moves and strikes with its own corners presses with
/// these.
void spreadOverFaces(const ContactBody& body, Strike& strike) {
    constexpr std::size_t next = 2;  // on either side of a corner
    std::vector<StrikePoint*> flat;
    for (StrikePoint& point : strike.points)
        if (point.contact->partner_is_flat && point.share > 0) flat.push_back(&point);
    UnionFind faces(flat.size());
    std::vector<double> ways(flat.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < flat.size(); ++i) {
        std::vector<std::pair<double, std::size_t>> others;
        for (std::size_t j = 0; j < flat.size(); ++j)
            if (j != i) others.emplace_back((flat[i]->spot.point - flat[j]->spot.point).norm(), j);
        const std::size_t asked = std::min(next, others.size());
        std::partial_sort(others.begin(), others.begin() + static_cast<long>(asked), others.end());
        for (std::size_t k = 0; k < asked; ++k) {
            const auto& [way, j] = others[k];
            if (!areOnOneFace(body, *flat[i], *flat[j])) continue;
            faces.unite(static_cast<int>(i), static_cast<int>(j));
            ways[i] = std::min(ways[i], way);
        }
    }
    std::map<int, std::vector<std::size_t>> of_face;
    for (std::size_t i = 0; i < flat.size(); ++i) of_face[faces.root(static_cast<int>(i))].push_back(i);
    for (const auto& [root, own] : of_face) {
        std::vector<const StrikePoint*> corners;
        std::vector<Vec3> places;
        for (const std::size_t i : own) {
            corners.push_back(flat[i]);
            places.push_back(flat[i]->spot.point);
        }
        const double narrow = narrowSide(corners);
        const auto face = std::make_shared<const Footprint>(places, corners.front()->contact->normal,
                                                            level * body.radius_m);
        double way = std::numeric_limits<double>::infinity();
        for (const std::size_t i : own) way = std::min(way, ways[i]);
        const bool is_alone = !std::isfinite(way), is_ground = corners.front()->contact->partner_is_ground;
        if (!is_ground && (is_alone || !endsWithItsCorners(body, places, *face, way))) continue;
        for (const std::size_t i : own) {
            StrikePoint& corner = *flat[i];
            const bool is_of_face = std::isfinite(ways[i]);
            const double own_part = (is_of_face ? ways[i] : body.wall_thickness_m) / 2,
                         touches = is_of_face ? std::min(1.0, narrow / own_part) : 0;
            corner.face = face;
            corner.on_face_m = touches * touches * own_part;
            corner.closed_gap_m = 2 * level * corner.on_face_m;
            if (touches == 1) continue;
            const double force =
                hertzPeakForce(corner.hertz, corner.share * strike.mass(0), strike.speed_m_s);
            const double room = std::min(own_part, corner.contact->partner_reach_m);
            const PressedPart pressed = room > 0 ? pressedAbout(body, corner, force, room) : PressedPart{};
            // What is round and not tilted is Hertz's.
            const double least = is_of_face ? corner.on_face_m : 1.2 * hertzPatchRadius(corner.hertz, force);
            if (!(pressed.radius_m > least)) continue;
            corner.is_tilted = true;
            corner.on_face_m = pressed.radius_m;
            corner.closed_gap_m = 2 * pressed.depth_m;
        }
    }
}

/// Of the surface about a corner of a face, without what lies in a hollow of it, or beside what it stands on.
void keepWhatTouches(const StrikePoint& corner, std::vector<PatchPart>& parts) {
    const Vec3& push = corner.contact->normal;
    const double beside = corner.is_tilted ? corner.on_face_m : 0;
    std::vector<PatchPart> touching_parts;
    for (const PatchPart& part : parts)
        if (corner.face->outside(part.centre) <= beside &&
            std::abs((part.centre - corner.spot.point).dot(push)) < corner.closed_gap_m)
            touching_parts.push_back(part);
    if (!touching_parts.empty()) parts = std::move(touching_parts);
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
