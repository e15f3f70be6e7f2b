#include "generators/coffee_plate.h"

#include "generators/implicit_shapes.h"

namespace sherd::generators {
namespace {

/// Distance in the half-plane (radius, height) to the centre line: a straight part from the axis, then an arc
/// that leaves it without a kink.
double offCentreLine(const PlateMeasures& plate, const Eigen::Vector2d& point) {
    const double run = plate.rim_radius - plate.flat_radius;
    const double opening = 2 * std::atan2(plate.rise, run);  // of the arc
    const double bend = run / std::sin(opening);
    if (point.x() <= plate.flat_radius) return std::abs(point.y());
    const Eigen::Vector2d from_centre = point - Eigen::Vector2d(plate.flat_radius, bend);
    const double angle = std::atan2(from_centre.x(), -from_centre.y());
    if (angle >= 0 && angle <= opening) return std::abs(from_centre.norm() - bend);
    return (point - Eigen::Vector2d(plate.rim_radius, plate.rise)).norm();
}

double plateDistance(const PlateMeasures& plate, const Eigen::Vector3d& point) {
    const Eigen::Vector2d section(std::hypot(point.x(), point.y()), point.z());
    const double middle_height = plate.foot_height + plate.thickness / 2;
    const double disc =
        offCentreLine(plate, section - Eigen::Vector2d(0, middle_height)) - plate.thickness / 2;
    const double rounding = plate.foot_width / 4;
    const Eigen::Vector2d half(plate.foot_width / 2 - rounding, middle_height / 2 - rounding);
    const double foot =
        roundedRectangle(section - Eigen::Vector2d(plate.foot_radius, middle_height / 2), half, rounding);
    return uniteRound(disc, foot, plate.foot_fillet);
}

}  // namespace

ImplicitSolid coffeePlate(const PlateMeasures& plate) {
    ImplicitSolid solid;
    solid.distance = [plate](const Eigen::Vector3d& point) { return plateDistance(plate, point); };
    solid.inner_point = {0, 0, plate.foot_height + plate.thickness / 2};
    solid.bounding_radius = 1.3 * plate.rim_radius;
    solid.fineness.triangle_radius = 0.0030;
    solid.fineness.surface_distance = 0.000085;
    return solid;
}

}  // namespace sherd::generators
