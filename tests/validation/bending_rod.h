#pragma once

#include "validation/closed_form.h"

namespace sherd::validation::bending_rod {

inline constexpr double length = 1, side = 0.1, force = 1000;

/// Relative L2 error of the bending stress of a free rod struck in its middle, over the surface points of its
/// halves. Inertia loads it by F/L a length, so that M = F s^2 / (2 L), s from the nearer end, and sigma = M
/// z / I, I = a^4/12.
inline double bendingError(const StressSettings& settings, double spacing, const Mat3& tilt) {
    const auto solid = sampledForSplines(shapes::moved(shapes::slab({length, side, side}, 20, 2, 2), tilt),
                                         spacing, Basis::quadratic);
    const auto loads =
        spreadOverSurface(*solid, tilt * Vec3(0, 0, -force), [&](const Vec3& x, const Vec3& normal) {
            return (tilt.transpose() * normal).z() > 0.9 && std::abs((tilt.transpose() * x).x()) < side / 2;
        });
    const StressField field = valueOf(build(solid, elasticMaterial(), settings).solve(loads));
    double error = 0, norm = 0;
    for (size_t i = 0; i < solid->surface_points.size(); ++i) {
        const Vec3 x = tilt.transpose() * solid->surface_points[i].position;
        const double from_end = length / 2 - std::abs(x.x());
        if (from_end < side || from_end > 0.4 * length) continue;
        const double moment = -force * from_end * from_end / (2 * length);
        const double expected = moment * x.z() * 12 / std::pow(side, 4);
        const double found = (tilt.transpose() * toMatrix(field.surface[i]) * tilt)(0, 0);
        error += std::pow(found - expected, 2);
        norm += expected * expected;
    }
    return std::sqrt(error / norm);
}

}  // namespace sherd::validation::bending_rod
