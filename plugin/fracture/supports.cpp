#include "fracture/supports.h"

#include <algorithm>

#include "core/loads/surface_region.h"
#include "core/numerics/mesh_measures.h"

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
        const double across = spreadOf(original, region).width_m() / points_across;
        const auto points =
            regionQuadrature(original, region, std::clamp(across, finest * spacing_m, spacing_m));
        if (!points) return Error{"A support cannot be placed: " + points.error()};
        for (const AreaPoint& p : points.value()) supports.push_back({p.position, p.area_m2});
    }
    return supports;
}

const SurfaceRegion* supportThatHoldsAll(const TriangleMesh& surface,
                                         const std::vector<SurfaceRegion>& regions,
                                         const std::vector<SupportPoint>& points) {
    constexpr double nearly = 0.999, quadrature = 0.99;
    const double most_m2 = nearly * surfaceArea(surface);
    double together_m2 = 0;
    for (const SupportPoint& point : points) together_m2 += point.area_m2;
    if (together_m2 < quadrature * most_m2) return nullptr;  // as nearly always, and at once
    const TriangleMesh original = withoutCrackFaces(surface);
    const auto all = std::find_if(regions.begin(), regions.end(), [&](const SurfaceRegion& region) {
        return spreadOf(original, region).area_m2() > most_m2;
    });
    return all == regions.end() ? nullptr : &*all;
}

std::vector<SurfaceRegion> supportsThatHold(const TriangleMesh& piece,
                                            const std::vector<SurfaceRegion>& regions, double spacing_m,
                                            double wall_thickness_m) {
    constexpr double smallest_area = 0.5;    // of a particle's face
    constexpr double smallest_width = 0.17;  // of spacing or wall: about a narrower strip a body can turn
    std::vector<SurfaceRegion> holding;
    if (regions.empty()) return holding;
    const TriangleMesh original = withoutCrackFaces(piece);
    AreaSpread together(boundingBox(piece).center());
    for (const SurfaceRegion& region : regions) {
        AreaSpread with_it = together;
        with_it.add(original, region);
        const double own_m2 = with_it.area_m2() - together.area_m2();
        if (own_m2 < smallest_area * spacing_m * spacing_m) continue;
        holding.push_back(region);
        together = with_it;
    }
    if (together.width_m() < smallest_width * std::min(spacing_m, wall_thickness_m)) return {};
    return holding;
}

}  // namespace sherd
