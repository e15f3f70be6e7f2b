#include "bullet/convex_decomposition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace sherd {

namespace {

constexpr int directions = 42;  // of the hulls that are only used to compare volumes
constexpr std::size_t compared_points =
    500;  // size of the sample of points by which cuts are compared, about

/// A part of the solid between cuts.
struct Part {
    std::vector<Vec3> points;  // of the surface, and where cuts cross it; the hull of the part is theirs
    std::vector<std::array<int, 3>> triangles;
    /// These close the surface at the cuts, for the volume only: fans about a point of the plane, whose
    /// signed areas add up to the area of the section.
    std::vector<std::array<Vec3, 3>> caps;
    double air = 0;  // empty volume of the hull, m^3
};

struct Plane {
    int axis = 0;
    double offset = 0;
    double height(const Vec3& x) const { return x[axis] - offset; }
};

/// Merges the vertices in each cell of a grid. The surface stays closed, so its volume is still defined.
Part merged(const TriangleMesh& surface, double cell) {
    Part part;
    std::map<std::tuple<long, long, long>, int> point_of_cell;
    std::vector<int> point_of_vertex;
    for (const Vec3& x : surface.vertices) {
        const auto place = [&](int axis) { return std::lround(x[axis] / cell); };
        const auto [entry, is_new] =
            point_of_cell.try_emplace({place(0), place(1), place(2)}, static_cast<int>(part.points.size()));
        if (is_new) part.points.push_back(x);
        point_of_vertex.push_back(entry->second);
    }
    for (const auto& [a, b, c] : surface.triangles) {
        const std::array<int, 3> t = {point_of_vertex[a], point_of_vertex[b], point_of_vertex[c]};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) part.triangles.push_back(t);
    }
    return part;
}

double sixVolumes(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c));
}

double solidVolume(const Part& part) {
    if (part.points.empty()) return 0;
    const Vec3 o = part.points.front();
    double sum = 0;
    for (const auto& [a, b, c] : part.triangles)
        sum += sixVolumes(part.points[a] - o, part.points[b] - o, part.points[c] - o);
    for (const auto& cap : part.caps) sum += sixVolumes(cap[0] - o, cap[1] - o, cap[2] - o);
    return sum / 6;
}

/// The part of a triangle (corners, and heights over the plane) above (or below) the plane, as a polygon.
struct Clipped {
    std::array<Vec3, 4> corners;
    std::array<int, 4> old_corner;  // -1: on the plane
    int count = 0;
    std::optional<std::array<Vec3, 2>> section;  // the edge in the plane
};

Clipped clip(const std::array<Vec3, 3>& x, const Plane& plane, bool above) {
    Clipped part;
    std::array<Vec3, 2> section;
    bool crosses = false;
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        const double h = plane.height(x[i]), h_next = plane.height(x[next]);
        const bool in = (h >= 0) == above, next_in = (h_next >= 0) == above;
        if (in) {
            part.corners[part.count] = x[i];
            part.old_corner[part.count++] = i;
        }
        if (in == next_in) continue;
        const Vec3 crossing = x[i] + h / (h - h_next) * (x[next] - x[i]);
        part.corners[part.count] = crossing;
        part.old_corner[part.count++] = -1;
        section[in ? 0 : 1] = crossing;
        crosses = true;
    }
    if (crosses) part.section = section;
    return part;
}

/// The part of a solid on one side of a plane.
Part half(const Part& whole, const Plane& plane, bool above) {
    Part part;
    Vec3 fan_centre = whole.points.front();
    fan_centre[plane.axis] = plane.offset;
    const auto close = [&](const Clipped& clipped) {
        if (clipped.section) part.caps.push_back({fan_centre, (*clipped.section)[1], (*clipped.section)[0]});
    };
    std::vector<int> new_index(whole.points.size(), -1);
    for (std::size_t p = 0; p < whole.points.size(); ++p) {
        if ((plane.height(whole.points[p]) >= 0) != above) continue;
        new_index[p] = static_cast<int>(part.points.size());
        part.points.push_back(whole.points[p]);
    }
    for (const auto& t : whole.triangles) {
        const int kept = (new_index[t[0]] >= 0) + (new_index[t[1]] >= 0) + (new_index[t[2]] >= 0);
        if (kept == 3) part.triangles.push_back({new_index[t[0]], new_index[t[1]], new_index[t[2]]});
        if (kept == 0 || kept == 3) continue;
        const Clipped clipped =
            clip({whole.points[t[0]], whole.points[t[1]], whole.points[t[2]]}, plane, above);
        std::array<int, 4> corners;
        for (int i = 0; i < clipped.count; ++i) {
            const int old_corner = clipped.old_corner[i];
            corners[i] = old_corner >= 0 ? new_index[t[old_corner]] : static_cast<int>(part.points.size());
            if (old_corner < 0) part.points.push_back(clipped.corners[i]);
        }
        for (int i = 2; i < clipped.count; ++i)
            part.triangles.push_back({corners[0], corners[i - 1], corners[i]});
        close(clipped);
    }
    for (const auto& cap : whole.caps) {
        const Clipped clipped = clip(cap, plane, above);
        for (int i = 2; i < clipped.count; ++i)
            part.caps.push_back({clipped.corners[0], clipped.corners[i - 1], clipped.corners[i]});
        close(clipped);
    }
    return part;
}

std::vector<Plane> possibleCuts(const Part& part) {
    Eigen::AlignedBox3d box;
    for (const Vec3& x : part.points) box.extend(x);
    std::vector<Plane> cuts;
    for (int axis = 0; axis < 3; ++axis)
        for (const double share : {0.25, 0.5, 0.75})
            cuts.push_back({axis, box.min()[axis] + share * box.sizes()[axis]});
    return cuts;
}

/// Approximate volume of the two hulls after a cut, from a sample of the points: enough to compare cuts.
double hullVolumesAfter(const Part& part, const Plane& plane) {
    const std::size_t stride = 1 + part.points.size() / compared_points;
    std::array<std::vector<Vec3>, 2> points;
    for (std::size_t p = 0; p < part.points.size(); p += stride)
        points[plane.height(part.points[p]) >= 0].push_back(part.points[p]);
    for (std::size_t t = 0; t < part.triangles.size(); t += stride) {
        for (int i = 0; i < 3; ++i) {
            const Vec3& a = part.points[part.triangles[t][i]];
            const Vec3& b = part.points[part.triangles[t][(i + 1) % 3]];
            const double h_a = plane.height(a), h_b = plane.height(b);
            // Each edge belongs to two triangles, once in either direction.
            if (h_a < 0 || h_b >= 0) continue;
            const Vec3 crossing = a + h_a / (h_a - h_b) * (b - a);
            points[0].push_back(crossing);
            points[1].push_back(crossing);
        }
    }
    return roughHull(points[0], directions).volume + roughHull(points[1], directions).volume;
}

Plane bestCut(const Part& part) {
    Plane best;
    double least = std::numeric_limits<double>::infinity();
    for (const Plane& plane : possibleCuts(part)) {
        const double volume = hullVolumesAfter(part, plane);
        if (volume >= least) continue;
        least = volume;
        best = plane;
    }
    return best;
}

}  // namespace

std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double smallest_detail_m,
                                            const DecompositionLimits& limits) {
    std::vector<Part> parts = {merged(surface, smallest_detail_m)};
    const auto measure = [](Part& part) {
        part.air = roughHull(part.points, directions).volume - solidVolume(part);
    };
    measure(parts.front());
    const double enough = limits.air_share * solidVolume(parts.front());
    while (static_cast<int>(parts.size()) < limits.most_parts) {
        const auto airiest = std::max_element(parts.begin(), parts.end(),
                                              [](const Part& a, const Part& b) { return a.air < b.air; });
        if (airiest->air <= enough) break;
        const Plane cut = bestCut(*airiest);
        Part above = half(*airiest, cut, true);
        *airiest = half(*airiest, cut, false);
        measure(*airiest);
        measure(above);
        parts.push_back(std::move(above));
    }
    std::vector<ConvexHull> hulls;
    for (const Part& part : parts) hulls.push_back(roughHull(part.points, limits.most_vertices));
    return hulls;
}

}  // namespace sherd
