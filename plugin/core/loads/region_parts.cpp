#include "core/loads/region_parts.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/pi.h"
#include "core/numerics/plane_crossing.h"

namespace sherd {

namespace {

constexpr double relative_tolerance = 1e-6;  // of the body's size: how far from a flat box a face may lie
constexpr double cylinder_tolerance = 1e-3;  // of the radius
constexpr int disc_sides = 128;              // of the polygon that stands for a sphere cut by a plane

/// The points with normal . x <= offset.
struct HalfSpace {
    Vec3 normal;
    double offset;
};

/// The part of a polygon in a half-space.
ConvexPolygon clipped(const ConvexPolygon& polygon, const HalfSpace& half) {
    ConvexPolygon inside;
    const auto height = [&](int i) { return half.normal.dot(polygon[i]) - half.offset; };
    walkAcrossPlane(
        static_cast<int>(polygon.size()), [&](int i) { return height(i) > 0; },
        [&](int i, bool above) {
            if (!above) inside.push_back(polygon[i]);
        },
        [&](int i, int next, bool) {
            inside.push_back(planeCrossing(polygon[i], height(i), polygon[next], height(next)));
        });
    return inside;
}

ConvexPolygon clipped(const TriangleCorners& t, const std::vector<HalfSpace>& halves) {
    ConvexPolygon polygon(t.begin(), t.end());
    for (const HalfSpace& half : halves) {
        polygon = clipped(polygon, half);
        if (polygon.size() < 3) return {};
    }
    return polygon;
}

/// The sphere cuts the triangle's plane in a disc, which is replaced by a regular polygon of the same area.
/// That polygon depends on the plane alone, so the parts of neighbouring triangles of one flat face tile it.
ConvexPolygon partInside(const SphereRegion& sphere, const TriangleCorners& t, double) {
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3, normal = areaVector(t).normalized();
    double reach = 0;
    for (const Vec3& corner : t) reach = std::max(reach, (corner - middle).norm());
    const double height = normal.dot(t[0] - sphere.centre);
    const double squared = sphere.radius_m * sphere.radius_m - height * height;
    if ((middle - sphere.centre).norm() > sphere.radius_m + reach || !(squared > 0)) return {};

    const double apothem = std::sqrt(squared * pi / (disc_sides * std::tan(pi / disc_sides)));
    const Vec3 centre = sphere.centre + height * normal;
    if (std::all_of(t.begin(), t.end(), [&](const Vec3& c) { return (c - centre).norm() <= apothem; }))
        return {t.begin(), t.end()};
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<HalfSpace> sides;
    for (int i = 0; i < disc_sides; ++i) {
        const double angle = 2 * pi * i / disc_sides;
        const Vec3 outward = std::cos(angle) * u + std::sin(angle) * v;
        sides.push_back({outward, outward.dot(centre) + apothem});
    }
    return clipped(t, sides);
}

ConvexPolygon partInside(const BoxRegion& box, const TriangleCorners& t, double tolerance) {
    std::vector<HalfSpace> sides;
    for (int axis = 0; axis < 3; ++axis) {
        sides.push_back({Vec3::Unit(axis), box.hi[axis] + tolerance});
        sides.push_back({-Vec3::Unit(axis), -box.lo[axis] + tolerance});
    }
    return clipped(t, sides);
}

/// The whole triangle if its corners lie on the cylinder and it is no part of an end face, else nothing.
ConvexPolygon partInside(const CylinderRegion& cylinder, const TriangleCorners& t, double tolerance) {
    const Vec3 axis = cylinder.axis.normalized();
    const auto radial = [&](const Vec3& x) {
        const Vec3 arm = x - cylinder.point;
        return Vec3(arm - axis * axis.dot(arm));
    };
    const double allowed = std::max(tolerance, cylinder_tolerance * cylinder.radius_m);
    for (const Vec3& corner : t)
        if (std::abs(radial(corner).norm() - cylinder.radius_m) > allowed) return {};
    if (std::abs(axis.dot(areaVector(t).normalized())) > 0.5) return {};
    return {t.begin(), t.end()};
}

/// Whether a polygon is a strip as narrow as the tolerance, as a flat box cuts from the faces that adjoin the
/// one it lies on.
bool isSliver(const ConvexPolygon& polygon, double tolerance) {
    double longest = 0;
    for (const Vec3& p : polygon) longest = std::max(longest, (p - polygon[0]).norm());
    return areaOf(polygon) <= 4 * tolerance * longest;
}

double toleranceOf(const TriangleMesh& surface) {
    return relative_tolerance * boundingBox(surface.vertices).diagonal().norm();
}

/// The part of a triangle in a region; empty where the two only touch.
ConvexPolygon partInside(const SurfaceRegion& region, const TriangleCorners& triangle, double tolerance) {
    ConvexPolygon part =
        std::visit([&](const auto& r) { return partInside(r, triangle, tolerance); }, region);
    if (!part.empty() && isSliver(part, tolerance)) part.clear();
    return part;
}

}  // namespace

double areaOf(const ConvexPolygon& polygon) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += areaVector({polygon[0], polygon[i - 1], polygon[i]});
    return sum.norm();
}

std::vector<ConvexPolygon> partsInside(const TriangleMesh& surface, const SurfaceRegion& region) {
    const double tolerance = toleranceOf(surface);
    std::vector<ConvexPolygon> parts;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        ConvexPolygon part = partInside(region, cornersOf(surface, t), tolerance);
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

RegionOnSurface::RegionOnSurface(const TriangleMesh& surface, const SurfaceRegion& region)
    : region_(region), tolerance_(toleranceOf(surface)) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        has_part_.push_back(!partInside(region, cornersOf(surface, t), tolerance_).empty());
}

bool RegionOnSurface::holds(int triangle, const Vec3& x) const {
    return has_part_[static_cast<std::size_t>(triangle)] && mayHold(x, tolerance_);
}

bool RegionOnSurface::mayHold(const Vec3& x, double reach) const {
    if (const auto* sphere = std::get_if<SphereRegion>(&region_))
        return (x - sphere->centre).norm() <= sphere->radius_m + reach;
    if (const auto* box = std::get_if<BoxRegion>(&region_))
        return ((x - box->lo).array() >= -reach).all() && ((box->hi - x).array() >= -reach).all();
    return true;  // a cylinder holds whole triangles
}

}  // namespace sherd
