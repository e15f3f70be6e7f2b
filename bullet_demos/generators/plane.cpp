#include "generators/plane.h"

#include "generators/implicit_shapes.h"

namespace sherd::generators {
namespace {

using Eigen::Vector3d;

double roundCone(const Taper& cone, const Vector3d& point) {
    const Vector3d axis = cone.to - cone.from, offset = point - cone.from;
    const double length = axis.norm(), along = offset.dot(axis) / length;
    const double off = std::sqrt(std::max(0.0, offset.squaredNorm() - along * along));
    return taperedCapsule(along, off, cone.from_radius, cone.to_radius, length);
}

/// A plate with the strip's outline and round edges, square to `normal`.
double strip(const Taper& outline, const Vector3d& normal, double thickness, const Vector3d& point) {
    const Vector3d axis = outline.to - outline.from, offset = point - outline.from;
    const double length = axis.norm(), along = offset.dot(axis) / length;
    const double off = std::abs(offset.dot(normal.cross(axis))) / length;
    const double inside = taperedCapsule(along, off, outline.from_radius, outline.to_radius, length);
    return intersectRound(inside, std::abs(offset.dot(normal)) - thickness / 2, 0.48 * thickness);
}

double planeDistance(const PlaneMeasures& m, const Vector3d& point) {
    const Vector3d mirrored(point.x(), std::abs(point.y()), point.z());
    // Both cones end in the same ball, so that they meet without an edge.
    const double fuselage = std::min(roundCone(m.front, point), roundCone(m.rear, point));
    double solid = uniteRound(fuselage, roundCone(m.canopy, point), m.fillet);
    solid = uniteRound(solid, strip(m.wing, Vector3d::UnitZ(), m.wing_thickness, mirrored), m.fillet);
    solid = uniteRound(solid, strip(m.tail, Vector3d::UnitZ(), m.tail_thickness, mirrored), m.fillet);
    return uniteRound(solid, strip(m.fin, Vector3d::UnitY(), m.tail_thickness, point), m.fillet);
}

}  // namespace

ImplicitSolid plane(const PlaneMeasures& measures) {
    ImplicitSolid solid;
    solid.distance = [measures](const Vector3d& point) { return planeDistance(measures, point); };
    solid.inner_point = measures.front.from;
    solid.bounding_radius = 0.25;
    solid.fineness.triangle_radius = 0.0045;
    solid.fineness.surface_distance = 0.00012;
    return solid;
}

}  // namespace sherd::generators
