#include <sherd/explosion.h>
#include <sherd/fracture_world.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "bullet/fracture_world_impl.h"
#include "bullet/world/conversions.h"
#include "core/loads/load_patch.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"
#include "fracture/breakable_solid.h"
#include "geometry/cutting/point_location.h"

namespace sherd {

namespace {

/// What of the blast falls on a part of a surface. Asset frame, the centre of the explosion at the origin.
struct Exposure {
    double solid_angle = 0;
    Vec3 direction = Vec3::Zero();  // unit vectors away from the centre, over the solid angle
    Vec3 place = Vec3::Zero();      // times the solid angle
    double square = 0;              // |place|^2 times the solid angle

    void add(const Exposure& part) {
        solid_angle += part.solid_angle;
        direction += part.direction;
        place += part.place;
        square += part.square;
    }
    Vec3 mean() const { return place / solid_angle; }
    /// Of the disc whose points are as far from its middle as these are from theirs, in the mean square.
    double radius() const {
        return std::sqrt(std::max(0.0, 2 * (square / solid_angle - mean().squaredNorm())));
    }
};

/// Of a triangle seen from the origin; below zero from its back. A. van Oosterom, J. Strackee, The solid
/// angle of a plane triangle (1983), Eq. 8.
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double lengths[] = {a.norm(), b.norm(), c.norm()};
    const double volume = a.dot(b.cross(c));
    return 2 * std::atan2(volume, lengths[0] * lengths[1] * lengths[2] + a.dot(b) * lengths[2] +
                                      b.dot(c) * lengths[0] + c.dot(a) * lengths[1]);
}

/// The unit vectors towards a triangle, seen from the origin, over its solid angle: half the angle that each
/// side is seen under, along the normal of the plane through that side and the origin (Lambert's formula for
/// the light of a polygon).
Vec3 directionOver(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto ofSide = [](const Vec3& from, const Vec3& to) {
        const Vec3 normal = from.cross(to);
        const double sine = normal.norm();
        return sine > 0 ? Vec3(0.5 * std::atan2(sine, from.dot(to)) / sine * normal) : Vec3(Vec3::Zero());
    };
    return ofSide(a, b) + ofSide(b, c) + ofSide(c, a);
}

/// How triangles are divided: into parts that are no larger than they are far away, nor than `largest_m`.
struct Division {
    double reach_m, largest_m;
};

/// What a triangle exposes that faces the centre.
Exposure exposureOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& middle, double edge) {
    constexpr double small = 0.02;  // over the distance: all of it is seen alike, to 0.02 %
    const double within =
        ((a - middle).squaredNorm() + (b - middle).squaredNorm() + (c - middle).squaredNorm()) / 12;
    const double squared = middle.squaredNorm();
    if (edge * edge <= small * small * squared) {
        const double distance = std::sqrt(squared);
        const double angle = -0.5 * (b - a).cross(c - a).dot(middle) / (squared * distance);
        return {angle, angle / distance * middle, angle * middle, angle * (squared + within)};
    }
    const double angle = -solidAngle(a, b, c);
    return {angle, -directionOver(a, b, c), angle * middle, angle * (squared + within)};
}

/// Adds what of a triangle is exposed. Triangles are counter-clockwise from outside: those with a volume
/// above zero show the centre their backs.
void addTriangle(const Vec3& a, const Vec3& b, const Vec3& c, const Division& division, int splits,
                 std::vector<Exposure>& exposed) {
    if (!(a.dot(b.cross(c)) < 0)) return;
    const Vec3 middle = (a + b + c) / 3;
    const double edge = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
    if (splits > 0 && edge > std::min(middle.norm(), division.largest_m)) {
        const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
        addTriangle(a, ab, ca, division, splits - 1, exposed);
        addTriangle(ab, b, bc, division, splits - 1, exposed);
        addTriangle(ca, bc, c, division, splits - 1, exposed);
        addTriangle(bc, ca, ab, division, splits - 1, exposed);
        return;
    }
    if (middle.squaredNorm() > division.reach_m * division.reach_m) return;
    const Exposure part = exposureOf(a, b, c, middle, edge);
    if (part.solid_angle > 0) exposed.push_back(part);
}

std::vector<Exposure> exposuresOf(const TriangleMesh& surface, const Vec3& centre, const Division& division) {
    constexpr int most_splits = 16;  // beyond the size of the body only what is near the centre is split on
    std::vector<Exposure> exposed;
    const auto vertex = [&](int v) { return Vec3(surface.vertices[v] - centre); };
    for (const auto& t : surface.triangles)
        addTriangle(vertex(t[0]), vertex(t[1]), vertex(t[2]), division, most_splits, exposed);
    return exposed;
}

/// Axes that turn with what is exposed: along the push on all of it, and across that along its length.
Mat3 axesOf(const std::vector<Exposure>& exposed) {
    Exposure all;
    for (const Exposure& part : exposed) all.add(part);
    Mat3 spread = Mat3::Zero();
    for (const Exposure& part : exposed) {
        const Vec3 arm = part.mean() - all.mean();
        spread += part.solid_angle * arm * arm.transpose();
    }
    constexpr double one_sided = 1e-3;  // else what is exposed lies all around the centre
    const bool has_side = all.direction.norm() > one_sided * all.solid_angle;
    const Mat3 own = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors();
    if (!has_side) return own;
    const Vec3 along = all.direction.normalized(), second = along.unitOrthogonal();
    Eigen::Matrix<double, 3, 2> across;
    across << second, along.cross(second);
    const Eigen::Matrix2d in_plane = across.transpose() * spread * across;
    const Vec3 longest =
        across * Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(in_plane).eigenvectors().col(1);
    Mat3 axes;
    axes << longest, along.cross(longest), along;
    return axes;
}

/// Joined by octants about those axes.
std::array<Exposure, 8> octantsOf(const std::vector<Exposure>& exposed) {
    const Mat3 axes = axesOf(exposed);
    std::array<Exposure, 8> octants;
    for (const Exposure& part : exposed) {
        const Vec3 at = axes.transpose() * part.direction;
        octants[(at.x() > 0) + 2 * (at.y() > 0) + 4 * (at.z() > 0)].add(part);
    }
    return octants;
}

/// A charge that lies on the surface, where a ray has met it, or in the solid: rounding may have it on the
/// inner side, and bombs stick in walls.
Vec3 offTheSurface(const BreakableSolid& solid, const Vec3& centre) {
    constexpr double skin = 0.05;  // of a particle spacing
    const double off = skin * solid.spacing();
    if ((centre - solid.moments().centroid).norm() > solid.boundingRadius() + off) return centre;
    const SurfaceTree& surface = solid.surfaceTree();
    constexpr int most_faces = 4;  // of a corner, one after the other
    Vec3 place = centre;
    if (isInside(centre, surface.surface().vertices, surface.surface().triangles)) {
        const SurfaceSpot spot = nearestSurfacePoint(surface, centre, Vec3::Zero());
        if (spot.triangle >= 0) place = spot.point;
    }
    for (int face = 0; face < most_faces; ++face) {
        const SurfaceSpot spot = nearestSurfacePoint(surface, place, Vec3::Zero());
        if (spot.triangle < 0 || (spot.point - place).norm() >= (1 - 1e-9) * off) break;
        place = spot.point + off * areaVector(cornersOf(surface.surface(), spot.triangle)).normalized();
    }
    return place;
}

std::vector<Push> pushesOn(const Breakable& body, const Explosion& explosion) {
    constexpr double nothing =
        1e-9;  // steradians, as a grain of 0.1 mm at 3 m: surface that is seen from its edge
    const BreakableSolid& solid = *body.asset.solid();
    const btTransform world_from_asset = body.placed(body.body->getWorldTransform());
    const Vec3 given = fromBullet(world_from_asset.inverse() * explosion.centre);
    const double away_m = (given - solid.moments().centroid).norm();
    if (away_m > solid.boundingRadius() + explosion.reach_m) return {};
    const Vec3 centre = offTheSurface(solid, given);
    std::vector<Push> pushes;
    constexpr double of_radius = 0.125;  // parts of the body that the octants are made of
    const Division division{explosion.reach_m, of_radius * solid.boundingRadius()};
    for (const Exposure& part : octantsOf(exposuresOf(body.asset.surface(), centre, division))) {
        if (!(part.solid_angle > nothing)) continue;
        const Vec3 impulse = explosion.impulse_n_s / (4 * pi) * part.direction;
        pushes.push_back({world_from_asset * toBullet(Vec3(centre + part.mean())),
                          world_from_asset.getBasis() * toBullet(impulse), part.radius()});
    }
    return pushes;
}

Status checkExplosion(const Explosion& explosion) {
    const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
    std::ostringstream sentence;
    if (!fromBullet(explosion.centre).allFinite())
        sentence << "the centre of the explosion is not finite; give it in m";
    else if (!positive(explosion.impulse_n_s))
        sentence << "the impulse of the explosion is " << explosion.impulse_n_s
                 << " but must be positive and finite, in N s";
    else if (!positive(explosion.reach_m))
        sentence << "the reach of the explosion is " << explosion.reach_m
                 << " but must be positive and finite, in m";
    else
        return success();
    return Error{sentence.str()};
}

}  // namespace

Result<int> explode(FractureWorld& world, const Explosion& explosion) {
    if (const Status valid = checkExplosion(explosion); !valid) return Error{valid.error()};
    // All pushes are there before anything breaks: fragments are not struck by the same explosion again.
    return world.applyBlows(
        world.impl_->pushesOnAll([&](const Breakable& body) { return pushesOn(body, explosion); }));
}

}  // namespace sherd
