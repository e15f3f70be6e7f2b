#include "fracture/supports.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/loads/surface_region.h"

namespace sherd {

namespace {

TriangleMesh withoutCrackFaces(const TriangleMesh& surface) {
    TriangleMesh original;
    original.vertices = surface.vertices;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        if (surface.kinds.empty() || surface.kinds[t] == SurfaceKind::original)
            original.triangles.push_back(surface.triangles[t]);
    return original;
}

/// Whether the points are spread along a line or less, in which case a body can turn about it.
bool areInLine(const std::vector<SupportPoint>& points, double width_m) {
    double area = 0;
    Vec3 mean = Vec3::Zero();
    for (const SupportPoint& p : points) {
        area += p.area_m2;
        mean += p.area_m2 * p.position;
    }
    mean /= area;
    Mat3 spread = Mat3::Zero();
    for (const SupportPoint& p : points)
        spread += p.area_m2 / area * (p.position - mean) * (p.position - mean).transpose();
    const Vec3 variances = Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues();
    return variances[1] < width_m * width_m;
}

}  // namespace

Result<std::vector<SupportPoint>> pointsOfSupports(const TriangleMesh& surface,
                                                   const std::vector<SurfaceRegion>& regions,
                                                   double spacing_m) {
    std::vector<SupportPoint> supports;
    if (regions.empty()) return supports;
    constexpr double points_across = 3;  // points in one row would not keep a body from turning
    constexpr double finest = 1.0 / 50;  // of the spacing: narrower strips hold as a line does
    const TriangleMesh original = withoutCrackFaces(surface);
    for (const SurfaceRegion& region : regions) {
        const double across = extentOf(original, region).width_m / points_across;
        const auto points =
            regionQuadrature(original, region, std::clamp(across, finest * spacing_m, spacing_m));
        if (!points) return Error{"A support cannot be placed: " + points.error()};
        for (const AreaPoint& p : points.value()) supports.push_back({p.position, p.area_m2});
    }
    return supports;
}

std::vector<SurfaceRegion> supportsThatHold(const TriangleMesh& piece,
                                            const std::vector<SurfaceRegion>& regions, double spacing_m,
                                            double wall_thickness_m) {
    constexpr double smallest_area = 0.5;    // of a particle's face
    constexpr double smallest_width = 0.05;  // of spacing or wall; standard deviation across the line
    std::vector<SurfaceRegion> holding;
    if (regions.empty()) return holding;
    std::vector<SupportPoint> points;
    const TriangleMesh original = withoutCrackFaces(piece);
    for (const SurfaceRegion& region : regions) {
        if (extentOf(original, region).area_m2 < smallest_area * spacing_m * spacing_m) continue;
        const auto of_region = pointsOfSupports(piece, {region}, spacing_m / 2);
        if (!of_region) continue;
        holding.push_back(region);
        points.insert(points.end(), of_region.value().begin(), of_region.value().end());
    }
    if (points.empty() || areInLine(points, smallest_width * std::min(spacing_m, wall_thickness_m)))
        return {};
    return holding;
}

}  // namespace sherd
