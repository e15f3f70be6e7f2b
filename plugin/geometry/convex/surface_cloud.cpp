#include "geometry/convex/surface_cloud.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"
#include "core/numerics/plane_crossing.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

constexpr double facing = 0.99;  // cosine, from which on a face lies across an axis

/// Whether the surface at a point lies across an axis, so that it need not meet a plane that is near.
bool liesAcross(const Vec3& area, int axis) {
    return area[axis] * area[axis] > facing * facing * area.squaredNorm();
}

/// Points with a list for each coordinate.
using Columns = std::array<std::vector<double>, 3>;

/// The points within a spacing of a plane, below and above it, where the surface may meet it.
std::array<Columns, 2> pointsNear(const AxisPlane& plane, const SurfaceCloud& cloud) {
    std::array<Columns, 2> near;
    for (std::size_t p = 0; p < cloud.points.size(); ++p) {
        const double height = plane.height(cloud.points[p]);
        if (std::abs(height) > cloud.spacing || liesAcross(cloud.areas[p], plane.axis)) continue;
        for (int d = 0; d < 3; ++d) near[height >= 0][d].push_back(cloud.points[p][d]);
    }
    return near;
}

/// Gives each of some points number `own` for its nearest one where that is nearer than what is known.
SHERD_WIDE_VECTORS void lookAt(const double* x, const double* y, const double* z, std::size_t count,
                               const double* candidate, double own, double* least, double* nearest) {
    const double a = candidate[0], b = candidate[1], c = candidate[2];
    for (std::size_t p = 0; p < count; ++p) {
        const double dx = a - x[p], dy = b - y[p], dz = c - z[p], distance = dx * dx + (dy * dy + dz * dz);
        const bool is_nearer = distance < least[p];
        least[p] = is_nearer ? distance : least[p];
        nearest[p] = is_nearer ? own : nearest[p];
    }
}

/// Where the surface crosses a plane: between each point close below it and the nearest one above, the first
/// of those that are equally near. None where the surface ends at the plane.
std::vector<Vec3> sectionOf(const SurfaceCloud& cloud, const AxisPlane& plane) {
    const double furthest = 2 * cloud.spacing;
    const auto [below, above] = pointsNear(plane, cloud);
    const std::size_t count = below[0].size();
    // All pairs are looked at: vector registers are faster at that than a search that leaves some out.
    std::vector<double> least(count, furthest * furthest), nearest(count, -1);
    const auto pointAt = [](const Columns& points, std::size_t p) {
        return Vec3(points[0][p], points[1][p], points[2][p]);
    };
    for (std::size_t p = 0; p < above[0].size(); ++p)
        lookAt(below[0].data(), below[1].data(), below[2].data(), count, pointAt(above, p).data(),
               static_cast<double>(p), least.data(), nearest.data());
    std::vector<Vec3> section;
    section.reserve(count);
    for (std::size_t p = 0; p < count; ++p) {
        if (nearest[p] < 0) continue;
        const Vec3 x = pointAt(below, p), partner = pointAt(above, static_cast<std::size_t>(nearest[p]));
        section.push_back(planeCrossing(x, plane.height(x), partner, plane.height(partner)));
    }
    return section;
}

}  // namespace

std::array<SurfaceCloud, 2> parted(const SurfaceCloud& cloud, const AxisPlane& plane) {
    std::array<SurfaceCloud, 2> parts;
    for (SurfaceCloud& part : parts) {
        part.spacing = cloud.spacing;
        part.steps = cloud.steps;
        part.cut_below = cloud.cut_below;
        part.cut_above = cloud.cut_above;
    }
    parts[0].cut_above[plane.axis] = parts[1].cut_below[plane.axis] = plane.offset;
    const std::vector<Vec3> section = sectionOf(cloud, plane);
    const auto above_count = static_cast<std::size_t>(std::count_if(
        cloud.points.begin(), cloud.points.end(), [&](const Vec3& x) { return plane.height(x) >= 0; }));
    for (int side = 0; side < 2; ++side) {
        const std::size_t own = side ? above_count : cloud.points.size() - above_count;
        parts[side].points.reserve(own + section.size());
        parts[side].areas.reserve(own + section.size());
    }
    for (std::size_t p = 0; p < cloud.points.size(); ++p) {
        SurfaceCloud& part = parts[plane.height(cloud.points[p]) >= 0];
        part.points.push_back(cloud.points[p]);
        part.areas.push_back(cloud.areas[p]);
    }
    for (SurfaceCloud& part : parts) {
        part.points.insert(part.points.end(), section.begin(), section.end());
        part.areas.resize(part.points.size(), Vec3::Zero());
    }
    return parts;
}

/// The flux through the surface of the field that points along an axis and grows along it from 0 at the only
/// section across that axis: none goes through the sections.
double solidVolume(const SurfaceCloud& cloud) {
    if (cloud.points.empty()) return 0;
    for (int axis = 0; axis < 3; ++axis) {
        const bool below = std::isfinite(cloud.cut_below[axis]), above = std::isfinite(cloud.cut_above[axis]);
        if (below && above) continue;
        const double zero =
            below ? cloud.cut_below[axis] : (above ? cloud.cut_above[axis] : cloud.points.front()[axis]);
        double volume = 0;
        for (std::size_t p = 0; p < cloud.points.size(); ++p)
            volume += (cloud.points[p][axis] - zero) * cloud.areas[p][axis];
        return std::max(volume, 0.0);
    }
    return -1;
}

bool isWellInside(const Vec3& x, const SurfaceCloud& whole) {
    const double nearest = whole.spacing / 2;
    double solid_angle = 0;
    for (std::size_t p = 0; p < whole.points.size(); ++p) {
        const Vec3 way = whole.points[p] - x;
        const double distance = way.norm();
        if (distance < nearest) return false;
        solid_angle += whole.areas[p].dot(way) / (distance * distance * distance);
    }
    return solid_angle > 2 * pi;
}

}  // namespace sherd
