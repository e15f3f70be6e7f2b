#include "bullet/convex_decomposition.h"

#include <algorithm>
#include <array>
#include <limits>

#include "bullet/solid_part.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/plane_crossing.h"

namespace sherd {

namespace {

constexpr int measuring_directions = 42;      // of the rough hulls whose volumes are compared
constexpr std::size_t compared_points = 500;  // about, of a part whose cuts are compared

std::vector<AxisPlane> possibleCuts(const SolidPart& part) {
    const Eigen::AlignedBox3d box = boundingBox(part.points);
    std::vector<AxisPlane> cuts;
    for (int axis = 0; axis < 3; ++axis)
        for (const double share : {0.25, 0.5, 0.75})
            cuts.push_back({axis, box.min()[axis] + share * box.sizes()[axis]});
    return cuts;
}

/// Volume of the two hulls after a cut, estimated from a sample of the points, m^3.
double hullVolumesAfter(const SolidPart& part, const AxisPlane& plane) {
    const std::size_t stride = 1 + part.points.size() / compared_points;
    std::array<std::vector<Vec3>, 2> points;
    for (std::size_t p = 0; p < part.points.size(); p += stride)
        points[plane.height(part.points[p]) >= 0].push_back(part.points[p]);
    for (std::size_t t = 0; t < part.triangles.size(); t += stride) {
        for (int i = 0; i < 3; ++i) {
            const Vec3& a = part.points[part.triangles[t][i]];
            const Vec3& b = part.points[part.triangles[t][(i + 1) % 3]];
            const double h_a = plane.height(a), h_b = plane.height(b);
            // Each edge belongs to two triangles, which run along it both ways.
            if (h_a < 0 || h_b >= 0) continue;
            const Vec3 crossing = planeCrossing(a, h_a, b, h_b);
            points[0].push_back(crossing);
            points[1].push_back(crossing);
        }
    }
    return roughHull(points[0], measuring_directions).volume +
           roughHull(points[1], measuring_directions).volume;
}

AxisPlane bestCut(const SolidPart& part) {
    AxisPlane best;
    double least = std::numeric_limits<double>::infinity();
    for (const AxisPlane& plane : possibleCuts(part)) {
        const double volume = hullVolumesAfter(part, plane);
        if (volume >= least) continue;
        least = volume;
        best = plane;
    }
    return best;
}

/// A part, and the volume of its hull that is not solid, m^3.
struct Candidate {
    SolidPart part;
    double air = 0;

    explicit Candidate(SolidPart cut_off)
        : part(std::move(cut_off)),
          air(roughHull(part.points, measuring_directions).volume - volumeOf(part)) {}
};

}  // namespace

std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double smallest_detail_m,
                                            const DecompositionLimits& limits) {
    std::vector<Candidate> parts;
    parts.emplace_back(simplifiedSolid(surface, smallest_detail_m));
    const double enough = limits.air_share * volumeOf(parts.front().part);
    while (static_cast<int>(parts.size()) < limits.most_parts) {
        const auto airiest = std::max_element(
            parts.begin(), parts.end(), [](const Candidate& a, const Candidate& b) { return a.air < b.air; });
        if (airiest->air <= enough) break;
        const AxisPlane cut = bestCut(airiest->part);
        Candidate above(cutOff(airiest->part, cut, true));
        *airiest = Candidate(cutOff(airiest->part, cut, false));
        parts.push_back(std::move(above));
    }
    std::vector<ConvexHull> hulls;
    for (const Candidate& candidate : parts)
        hulls.push_back(roughHull(candidate.part.points, limits.most_vertices));
    return hulls;
}

}  // namespace sherd
