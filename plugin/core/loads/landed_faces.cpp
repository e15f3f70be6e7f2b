#include "core/loads/landed_faces.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include "core/numerics/pi.h"
#include "core/numerics/union_find.h"

namespace sherd {

namespace {

constexpr double level = 1e-3;  // of the way between two corners: how deep a face may lie that touches

/// Whether the surface between two points of a strike is a face that lies on the same flat partner.
bool areOnOneFace(const ContactBody& body, const StrikePoint& a, const StrikePoint& b) {
    constexpr double beside = 0.02;  // of the way between them
    const Vec3& push = a.contact->normal;
    if (a.contact->partner != b.contact->partner || push.dot(b.contact->normal) < alike_normals) return false;
    const Vec3 middle = (a.spot.point + b.spot.point) / 2;
    const Vec3 off = nearestSurfacePoint(body.surface, middle, push).point - middle;
    const double way = (a.spot.point - b.spot.point).norm();
    return off.norm() < beside * way && std::abs(off.dot(push)) < level * way;
}

/// How wide the contact of a face is across its narrow side, m: half of a rectangle's width if its corners
/// press alike, and nothing if those on one edge do alone.
double narrowSide(const std::vector<StrikePoint*>& corners) {
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

/// Points of a strike that lie on one face, and of each how far the next of these is away, m; infinite: none.
struct Face {
    std::vector<StrikePoint*> corners;
    std::vector<double> ways;
};

std::vector<Face> facesOf(const ContactBody& body, Strike& strike) {
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
    std::map<int, Face> by_root;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        Face& face = by_root[faces.root(static_cast<int>(i))];
        face.corners.push_back(flat[i]);
        face.ways.push_back(ways[i]);
    }
    std::vector<Face> found;
    for (auto& [root, face] : by_root) found.push_back(std::move(face));
    return found;
}

/// `narrow_m`: of the face, see narrowSide. `way_m`: to the next corner of it, or infinite.
void spreadAbout(const ContactBody& body, const Strike& strike, double narrow_m, double way_m,
                 StrikePoint& corner) {
    const bool is_of_face = std::isfinite(way_m);
    const double own_part = (is_of_face ? way_m : body.wall_thickness_m) / 2,
                 touches = is_of_face ? std::min(1.0, narrow_m / own_part) : 0;
    corner.on_face_m = touches * touches * own_part;
    corner.closed_gap_m = 2 * level * corner.on_face_m;
    if (touches == 1) return;
    const double room = std::min(own_part, corner.contact->partner_reach_m);
    if (!(room > 0)) return;
    const double force = hertzPeakForce(corner.hertz, corner.share * strike.mass(0), strike.speed_m_s);
    const PressedPart pressed = pressedAbout(body, corner, force, room);
    // What is round and not tilted is Hertz's.
    const double least = is_of_face ? corner.on_face_m : 1.2 * hertzPatchRadius(corner.hertz, force);
    if (!(pressed.radius_m > least)) return;
    corner.is_tilted = true;
    corner.on_face_m = pressed.radius_m;
    corner.closed_gap_m = 2 * pressed.depth_m;
}

}  // namespace

void spreadOverFaces(const ContactBody& body, Strike& strike) {
    for (const Face& face : facesOf(body, strike)) {
        std::vector<Vec3> places;
        for (const StrikePoint* corner : face.corners) places.push_back(corner->spot.point);
        const ContactImpulse& contact = *face.corners.front()->contact;
        const auto footprint =
            std::make_shared<const Footprint>(places, contact.normal, level * body.radius_m);
        const double way = *std::min_element(face.ways.begin(), face.ways.end());
        const bool is_alone = !std::isfinite(way);
        if (!contact.partner_is_ground && (is_alone || !endsWithItsCorners(body, places, *footprint, way)))
            continue;
        const double narrow = narrowSide(face.corners);
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            face.corners[i]->face = footprint;
            spreadAbout(body, strike, narrow, face.ways[i], *face.corners[i]);
        }
    }
}

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

}  // namespace sherd
