#include <sherd/explosion.h>
#include <sherd/fracture_world.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "bullet/conversions.h"
#include "core/numerics/pi.h"

namespace sherd {

namespace {

/// What of the blast falls on a part of a surface. Asset frame, the centre of the explosion at the origin.
struct Exposure {
    double solid_angle = 0;
    Vec3 direction = Vec3::Zero();  // times the solid angle
    Vec3 place = Vec3::Zero();      // times the solid angle
    double square = 0;              // |place|^2 times the solid angle

    void add(const Vec3& at, double angle) {
        solid_angle += angle;
        direction += angle * at.normalized();
        place += angle * at;
        square += angle * at.squaredNorm();
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

using Octants = std::array<Exposure, 8>;

/// Adds a triangle, in parts that are not larger than they are far away.
void addTriangle(const Vec3& a, const Vec3& b, const Vec3& c, double reach_m, int splits, Octants& octants) {
    const Vec3 middle = (a + b + c) / 3;
    const double edge = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
    if (splits > 0 && edge > middle.norm()) {
        const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
        addTriangle(a, ab, ca, reach_m, splits - 1, octants);
        addTriangle(ab, b, bc, reach_m, splits - 1, octants);
        addTriangle(ca, bc, c, reach_m, splits - 1, octants);
        addTriangle(bc, ca, ab, reach_m, splits - 1, octants);
        return;
    }
    // Triangles are counter-clockwise from outside, so the angle is below zero where one faces the centre.
    const double angle = -solidAngle(a, b, c);
    if (!(angle > 0) || !(middle.norm() <= reach_m)) return;
    octants[(middle.x() > 0) + 2 * (middle.y() > 0) + 4 * (middle.z() > 0)].add(middle, angle);
}

Octants exposuresOf(const TriangleMesh& surface, const Vec3& centre, double reach_m) {
    constexpr int most_splits = 6;
    Octants octants;
    const auto vertex = [&](int v) { return Vec3(surface.vertices[v] - centre); };
    for (const auto& t : surface.triangles)
        addTriangle(vertex(t[0]), vertex(t[1]), vertex(t[2]), reach_m, most_splits, octants);
    return octants;
}

std::vector<Push> pushesOn(const FractureWorld& world, const btRigidBody* body, const Explosion& explosion) {
    constexpr double nothing =
        1e-9;  // steradians, as a grain of 0.1 mm at 3 m: surface that is seen from its edge
    const btTransform world_from_asset = world.assetTransform(body);
    const Vec3 centre = fromBullet(world_from_asset.inverse() * explosion.centre);
    std::vector<Push> pushes;
    for (const Exposure& part : exposuresOf(world.asset(body)->surface(), centre, explosion.reach_m)) {
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
                 << " but must be positive, in N s";
    else if (!positive(explosion.reach_m))
        sentence << "the reach of the explosion is " << explosion.reach_m << " but must be positive, in m";
    else
        return success();
    return Error{sentence.str()};
}

}  // namespace

Result<int> explode(FractureWorld& world, const Explosion& explosion) {
    if (const Status valid = checkExplosion(explosion); !valid) return Error{valid.error()};
    // All pushes are there before anything breaks: fragments are not struck by the same explosion again.
    std::vector<std::pair<btRigidBody*, std::vector<Push>>> blows;
    for (btRigidBody* body : world.bodies())
        if (std::vector<Push> pushes = pushesOn(world, body, explosion); !pushes.empty())
            blows.emplace_back(body, std::move(pushes));
    return world.applyBlows(blows);
}

}  // namespace sherd
