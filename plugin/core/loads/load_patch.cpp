#include "core/loads/load_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/loads/cap_area.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"
#include "core/stress/contact_disc.h"

namespace sherd {

namespace {

bool facesPush(const TriangleCorners& t, const Vec3& push) {
    return areaVector(t).dot(push) < 0;
}

/// Nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 nearestPoint(const TriangleCorners& t, const Vec3& p) {
    const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return t[0];
    const Vec3 bp = p - t[1];
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return t[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + ab * (d1 / (d1 - d3));
    const Vec3 cp = p - t[2];
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return t[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return t[1] + (t[2] - t[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    return t[0] + (ab * vb + ac * vc) / (va + vb + vc);
}

constexpr int deepest = 24;  // of subdivisions, each of which halves a triangle

/// Calls visit(centroid, area vector) for the parts of a triangle within `radius` of a point that are no
/// longer than longest(distance).
template <class Longest, class Visit>
void subdivideNear(const TriangleCorners& t, const Vec3& point, double radius, const Longest& longest,
                   int depth, const Visit& visit) {
    const double distance = (nearestPoint(t, point) - point).norm();
    if (distance > radius) return;
    const double edge = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    if (edge <= longest(distance) || depth == 0) return visit(Vec3((t[0] + t[1] + t[2]) / 3), areaVector(t));
    int first = 0;  // of the longest edge: slivers are not cut across their short side
    for (int k = 1; k < 3; ++k)
        if ((t[(k + 1) % 3] - t[k]).squaredNorm() > (t[(first + 1) % 3] - t[first]).squaredNorm()) first = k;
    const Vec3 &a = t[first], &b = t[(first + 1) % 3], &c = t[(first + 2) % 3], half = 0.5 * (a + b);
    subdivideNear(TriangleCorners{a, half, c}, point, radius, longest, depth - 1, visit);
    subdivideNear(TriangleCorners{half, b, c}, point, radius, longest, depth - 1, visit);
}

/// What may be within `radius` of a point. What is taken together is as large as triangles are that are
/// halved until none of their edges is longer than longest(distance).
template <class Longest>
SurfaceParts partsNear(const SurfaceTree& tree, const Vec3& point, double radius, const Longest& longest) {
    return tree.partsWhere(
        [&](const Eigen::AlignedBox3d& box) { return box.squaredExteriorDistance(point) <= radius * radius; },
        [&](const Eigen::AlignedBox3d& box) {
            return 2 * box.diagonal().norm() <= longest(box.exteriorDistance(point));
        });
}

/// Whether a ray meets a box.
bool meets(const Eigen::AlignedBox3d& box, const Vec3& from, const Vec3& direction) {
    double first = 0, last = std::numeric_limits<double>::infinity();
    for (int d = 0; d < 3; ++d) {
        if (direction[d] == 0) {
            if (from[d] < box.min()[d] || from[d] > box.max()[d]) return false;
            continue;
        }
        const double a = (box.min()[d] - from[d]) / direction[d], b = (box.max()[d] - from[d]) / direction[d];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

/// A direction in which some of the surface faces, and how much against the push, as a cosine.
struct Facing {
    Vec3 normal;
    double cosine;
};

/// Of those parts within `radius` of a point that face the push, directions rounded, each once: so that the
/// order of triangles does not matter. What faces the push most comes first.
std::vector<Facing> facingNormals(const TriangleMesh& surface, const SurfaceParts& parts, const Vec3& point,
                                  const Vec3& push, double radius) {
    std::map<RoundedNormal, double> found;
    const auto add = [&](const Vec3& area) {
        const Vec3 normal = area.normalized();
        double& cosine = found[rounded(normal)];
        cosine = std::max(cosine, -normal.dot(push));
    };
    for (const int t : parts.triangles) {
        const TriangleCorners triangle = cornersOf(surface, t);
        if (!facesPush(triangle, push) || (nearestPoint(triangle, point) - point).norm() > radius) continue;
        add(areaVector(triangle));
    }
    for (const FlatPart& part : parts.flat)
        if (part.area.dot(push) < 0 && (part.centre - point).norm() <= radius) add(part.area);
    std::vector<Facing> normals;
    for (const auto& [direction, cosine] : found) {
        const auto& [x, y, z] = direction;
        normals.push_back({Vec3(double(x), double(y), double(z)).normalized(), cosine});
    }
    std::stable_sort(normals.begin(), normals.end(),
                     [](const Facing& a, const Facing& b) { return a.cosine > b.cosine; });
    return normals;
}

/// How much a triangle faces the push, as a cosine, or of the faces that it goes on from smoothly the one
/// that does so most.
double smoothlyFacing(const Vec3& normal, const Vec3& push, const std::vector<Facing>& faces) {
    constexpr double turned_away = -0.65;  // on no face with what faces the push, rounding included
    const double own = -normal.dot(push);
    if (own < turned_away) return own;
    for (const Facing& face : faces) {
        if (face.cosine <= own) break;
        if (normal.dot(face.normal) >= on_one_face) return face.cosine;
    }
    return own;
}

/// What presses on a face beside one that faces the push more: less the more it turns away, and nothing on
/// the side of a box, so that it does not hang on a rounding error whether that faces the push.
double pressedShare(double cosine, double largest_cosine) {
    constexpr double least = 0.05;
    return std::clamp((cosine / largest_cosine - least) / (1 - least), 0.0, 1.0);
}

double lowestAlong(const Vec3& direction, const Eigen::AlignedBox3d& box) {
    return box.center().dot(direction) - (box.sizes() / 2).dot(direction.cwiseAbs());
}

}  // namespace

RoundedNormal rounded(const Vec3& normal) {
    constexpr double step = 0.05;
    return {std::lround(normal.x() / step), std::lround(normal.y() / step), std::lround(normal.z() / step)};
}

SurfaceSpot nearestSurfacePoint(const SurfaceTree& tree, const Vec3& point, const Vec3& push) {
    const TriangleMesh& surface = tree.surface();
    for (const bool facing : {true, false}) {
        const int nearest = tree.nearest(point, [&](int t) {
            const TriangleCorners triangle = cornersOf(surface, t);
            return facing && !facesPush(triangle, push)
                       ? std::numeric_limits<double>::infinity()
                       : (nearestPoint(triangle, point) - point).squaredNorm();
        });
        if (nearest >= 0) return {nearestPoint(cornersOf(surface, nearest), point), nearest};
    }
    return {point, -1};
}

SurfaceSpot touchedByAPlane(const SurfaceTree& tree, const Vec3& point, const Vec3& push, double gap) {
    const TriangleMesh& surface = tree.surface();
    const auto squaredTo = [&](const Vec3& corner) {
        return (corner - point).dot(push) > gap ? std::numeric_limits<double>::infinity()
                                                : (corner - point).squaredNorm();
    };
    const auto nearestCorner = [&](int t) {
        const TriangleCorners triangle = cornersOf(surface, t);
        return *std::min_element(triangle.begin(), triangle.end(),
                                 [&](const Vec3& a, const Vec3& b) { return squaredTo(a) < squaredTo(b); });
    };
    const int nearest = tree.nearest(point, [&](int t) {
        return facesPush(cornersOf(surface, t), push) ? squaredTo(nearestCorner(t))
                                                      : std::numeric_limits<double>::infinity();
    });
    return nearest < 0 ? SurfaceSpot{point, -1} : SurfaceSpot{nearestCorner(nearest), nearest};
}

double contactRadius(const SurfaceTree& tree, const Vec3& spot, const Vec3& push, double reach,
                     double depth) {
    const TriangleMesh& surface = tree.surface();
    double furthest = spot.dot(push);
    // What lies deeper than the cap below the spot lies deeper than the cap below what is further out.
    const std::vector<int> near = tree.unsortedWhere([&](const Eigen::AlignedBox3d& box) {
        return box.squaredExteriorDistance(spot) <= reach * reach &&
               lowestAlong(push, box) <= furthest + depth;
    });
    for (const int t : near)
        for (const Vec3& v : cornersOf(surface, t))
            if ((v - spot).squaredNorm() < reach * reach) furthest = std::min(furthest, v.dot(push));
    double area = 0;
    for (const int t : near) {
        const TriangleCorners triangle = cornersOf(surface, t);
        const double facing = -areaVector(triangle).normalized().dot(push);
        if (facing > 0) area += facing * capArea(triangle, spot, reach, {push, furthest + depth});
    }
    return area / (2 * pi * depth);
}

std::vector<PatchPart> partsOfPatch(const SurfaceTree& tree, const SurfaceSpot& spot, const Vec3& push,
                                    double radius, double length) {
    const auto longest = [&](double) { return length * radius; };
    const SurfaceParts near = partsNear(tree, spot.point, radius, longest);
    const std::vector<Facing> facing = facingNormals(tree.surface(), near, spot.point, push, radius);
    if (facing.empty()) return {};
    std::vector<PatchPart> parts;
    const auto pressedOn = [&](const Vec3& normal) {
        return pressedShare(smoothlyFacing(normal, push, facing), facing.front().cosine);
    };
    const auto add = [&](const Vec3& x, const Vec3& normal, double pressed, const Vec3& area) {
        const double share = pressed * contactProfile((x - spot.point).squaredNorm() / (radius * radius));
        if (share > 0) parts.push_back({x, normal, share * area.norm(), pressed});
    };
    for (const int t : near.triangles) {
        const TriangleCorners triangle = cornersOf(tree.surface(), t);
        const Vec3 normal = areaVector(triangle).normalized();
        const double pressed = pressedOn(normal);
        if (!(pressed > 0)) continue;
        subdivideNear(triangle, spot.point, radius, longest, deepest,
                      [&](const Vec3& x, const Vec3& area) { add(x, normal, pressed, area); });
    }
    for (const FlatPart& part : near.flat) {
        const Vec3 normal = part.area.normalized();
        add(part.centre, normal, pressedOn(normal), part.area);
    }
    return parts;
}

std::vector<PieceNearby> surfaceAround(const SurfaceTree& tree, const Vec3& point, double reach, double close,
                                       double size) {
    const auto longest = [&](double distance) { return size * std::max(1.0, distance / close); };
    std::vector<PieceNearby> pieces;
    const SurfaceParts near = partsNear(tree, point, reach, longest);
    for (const int t : near.triangles)
        subdivideNear(cornersOf(tree.surface(), t), point, reach, longest, deepest,
                      [&](const Vec3& x, const Vec3& area) {
                          pieces.push_back({x, area});
                      });
    for (const FlatPart& part : near.flat) pieces.push_back({part.centre, part.area});
    return pieces;
}

SurfaceSpot wayOut(const SurfaceTree& tree, const Vec3& from, const Vec3& direction) {
    SurfaceSpot spot{from, -1};
    double nearest = std::numeric_limits<double>::infinity();
    for (const int t :
         tree.trianglesWhere([&](const Eigen::AlignedBox3d& box) { return meets(box, from, direction); })) {
        const TriangleCorners corners = cornersOf(tree.surface(), t);
        const Vec3 area = areaVector(corners);
        const double facing = area.dot(direction);
        if (!(facing > 0)) continue;
        const double along = (corners[0] - from).dot(area) / facing;
        if (!(along > 0) || along >= nearest) continue;
        const Vec3 x = from + along * direction;
        const auto leftOf = [&](int a, int b) {
            return (corners[b] - corners[a]).cross(x - corners[a]).dot(area) >= 0;
        };
        if (!leftOf(0, 1) || !leftOf(1, 2) || !leftOf(2, 0)) continue;
        nearest = along;
        spot = {x, t};
    }
    return spot;
}

std::vector<PointForce> spreadForce(const std::vector<PatchPart>& parts, const SurfaceSpot& spot,
                                    const Vec3& force) {
    double weight = 0;
    for (const PatchPart& part : parts) weight += part.weight_m2;
    if (!(weight > 0)) return {{spot.point, force}};
    std::vector<PointForce> points;
    points.reserve(parts.size());
    for (const PatchPart& part : parts) points.push_back({part.centre, part.weight_m2 / weight * force});
    return points;
}

}  // namespace sherd
