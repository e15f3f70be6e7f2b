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

SurfaceFaces::SurfaceFaces(const ReadingPoints& points) {
    constexpr float alike = 0.8f;  // cosine between normals of one face
    starts.push_back(0);
    for (std::size_t part = 0; part + 1 < points.starts.size(); ++part) {
        const auto first = static_cast<std::ptrdiff_t>(faces.size());
        std::vector<Eigen::Vector3f> normals;
        std::vector<float> sizes;
        for (int at = points.starts[part]; at < points.starts[part + 1]; ++at) {
            const ReadingPoint& point = points.points[at];
            const float size = point.area.norm();
            if (!(size > 0)) continue;
            const Eigen::Vector3f normal = point.area / size;
            const auto same = std::find_if(normals.begin(), normals.end(), [&](const Eigen::Vector3f& other) {
                return other.dot(normal) > alike;
            });
            const auto face = same - normals.begin();
            if (same == normals.end()) {
                normals.push_back(normal);
                sizes.push_back(0);
                faces.emplace_back();
            }
            faces[first + face].xi += size * point.xi;
            faces[first + face].area += point.area;
            sizes[face] += size;
        }
        for (std::size_t face = 0; face < sizes.size(); ++face) faces[first + face].xi /= sizes[face];
        starts.push_back(static_cast<int>(faces.size()));
    }
}

}  // namespace sherd
