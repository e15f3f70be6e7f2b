#include "generators/coffee_cup.h"

#include "generators/implicit_shapes.h"

namespace sherd::generators {
namespace {

/// A straight-sided round block with a rounded foot and a rim as it is after firing.
double blockDistance(const CupMeasures& cup, double radius, double z) {
    const double side = radius - cup.outer_radius;
    const double foot = intersectRound(side, -z, cup.foot_rounding);
    return intersectRound(foot, z - cup.height, cup.rim_rounding);
}

/// A flat loop in the plane y = 0 from the axis outward; what lies in the block and its hollow does not show.
double handleDistance(const CupMeasures& cup, const Eigen::Vector3d& point) {
    const Eigen::Vector2d half(cup.handle_reach / 2, (cup.handle_top - cup.handle_bottom) / 2);
    const Eigen::Vector2d centre(cup.handle_reach / 2, (cup.handle_top + cup.handle_bottom) / 2);
    const Eigen::Vector2d bend = Eigen::Vector2d::Constant(cup.handle_bend);
    const Eigen::Vector2d in_plane(point.x(), point.z());
    const double off_line = roundedRectangle(in_plane - centre, half - bend, cup.handle_bend);
    const double flat = (cup.handle_width - cup.handle_thickness) / 2;
    return std::hypot(off_line, std::max(std::abs(point.y()) - flat, 0.0)) - cup.handle_thickness / 2;
}

}  // namespace

double cupDistance(const CupMeasures& cup, const Eigen::Vector3d& point) {
    const double radius = std::hypot(point.x(), point.y());
    const double block = blockDistance(cup, radius, point.z());
    const double solid = uniteRound(block, handleDistance(cup, point), cup.handle_fillet);
    // Hollowing comes last, so that nothing of the handle is left inside.
    const double hollow =
        intersectRound(radius - (cup.outer_radius - cup.wall), cup.wall - point.z(), cup.floor_rounding);
    return intersectRound(solid, -hollow, cup.rim_rounding);
}

ImplicitSolid coffeeCup(const CupMeasures& cup) {
    ImplicitSolid solid;
    solid.distance = [cup](const Eigen::Vector3d& point) { return cupDistance(cup, point); };
    solid.inner_point = {0, 0, cup.wall / 2};
    solid.bounding_radius = 1.5 * std::max(cup.height, cup.handle_reach + cup.handle_thickness);
    solid.fineness.triangle_radius = 0.0030;
    solid.fineness.surface_distance = 0.000085;
    return solid;
}

}  // namespace sherd::generators
