#include "core/mlpg/splines/reading_points.h"

#include <algorithm>
#include <limits>

namespace sherd {

namespace {

/// To whole steps, within the limit. A step is two millionths of a cell.
Eigen::Vector3f rounded(const Vec3& x) {
    constexpr double step = ReadingPoint::step, limit = ReadingPoint::limit;
    return ((x / step).array().round() * step).min(limit).max(-limit).cast<float>();
}

}  // namespace

ReadingPoints::ReadingPoints(const Discretisation& solid, const std::vector<GridPoint>& samples) {
    const std::size_t particles = solid.particles.size();
    std::vector<std::vector<ReadingPoint>> of_part(solid.parts.parts.size());
    for (std::size_t s = 0; s < samples.size(); ++s) {
        if (samples[s].part < 0) continue;
        ReadingPoint point;
        point.xi = rounded(samples[s].xi);
        point.particle = static_cast<int>(s);
        if (s >= particles) {
            const SurfacePoint& on_surface = solid.surface_points[s - particles];
            point.normal = rounded(on_surface.normal);
            point.area = on_surface.area.cast<float>();
            point.particle = solid.cells[on_surface.cell].particle;
        }
        of_part[samples[s].part].push_back(point);
    }
    starts.push_back(0);
    for (std::vector<ReadingPoint>& own : of_part) {
        std::stable_sort(own.begin(), own.end(), [](const ReadingPoint& a, const ReadingPoint& b) {
            return a.particle < b.particle;
        });
        points.insert(points.end(), own.begin(), own.end());
        starts.push_back(static_cast<int>(points.size()));
    }
}

Vec3 ReadingPoints::position(const CellParts& solid, int part, const ReadingPoint& point) {
    const Vec3 cells = solid.parts[part].cell.cast<double>() + Vec3::Constant(0.5) + point.xi.cast<double>();
    return solid.origin + cells.cwiseProduct(solid.edges);
}

int ReadingPoints::nearestTo(const GridPoint& place) const {
    int point = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int at = starts[place.part]; at < starts[place.part + 1]; ++at) {
        const double squared = (points[at].xi.cast<double>() - place.xi).squaredNorm();
        if (squared >= nearest) continue;
        nearest = squared;
        point = at;
    }
    return point;
}

}  // namespace sherd
