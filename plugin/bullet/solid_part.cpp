#include "bullet/solid_part.h"

#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/numerics/plane_crossing.h"

namespace sherd {

namespace {

double sixVolumes(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c));
}

/// The part of a triangle on one side of a plane, as a polygon.
struct ClippedTriangle {
    std::array<Vec3, 4> corners;
    std::array<int, 4> old_corner;  // of the triangle; -1: a new one on the plane
    int count = 0;
    std::optional<std::array<Vec3, 2>> section;  // the side that lies in the plane

    void add(const Vec3& corner, int old) {
        corners[count] = corner;
        old_corner[count++] = old;
    }
};

ClippedTriangle clip(const std::array<Vec3, 3>& x, const AxisPlane& plane, bool above) {
    ClippedTriangle part;
    std::array<Vec3, 2> section;
    bool crosses = false;
    walkAcrossPlane(
        3, [&](int i) { return plane.height(x[i]) >= 0; },
        [&](int i, bool is_above) {
            if (is_above == above) part.add(x[i], i);
        },
        [&](int i, int next, bool is_above) {
            const Vec3 crossing = planeCrossing(x[i], plane.height(x[i]), x[next], plane.height(x[next]));
            part.add(crossing, -1);
            section[is_above == above ? 0 : 1] = crossing;
            crosses = true;
        });
    if (crosses) part.section = section;
    return part;
}

}  // namespace

SolidPart simplifiedSolid(const TriangleMesh& surface, double cell_m) {
    SolidPart part;
    std::map<std::tuple<long, long, long>, int> point_of_cell;
    std::vector<int> point_of_vertex;
    for (const Vec3& x : surface.vertices) {
        const auto place = [&](int axis) { return std::lround(x[axis] / cell_m); };
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

double volumeOf(const SolidPart& part) {
    if (part.points.empty()) return 0;
    const Vec3 o = part.points.front();
    double sum = 0;
    for (const auto& [a, b, c] : part.triangles)
        sum += sixVolumes(part.points[a] - o, part.points[b] - o, part.points[c] - o);
    for (const auto& cap : part.caps) sum += sixVolumes(cap[0] - o, cap[1] - o, cap[2] - o);
    return sum / 6;
}

SolidPart cutOff(const SolidPart& whole, const AxisPlane& plane, bool above) {
    SolidPart part;
    Vec3 fan_centre = whole.points.front();
    fan_centre[plane.axis] = plane.offset;
    const auto close = [&](const ClippedTriangle& clipped) {
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
        const ClippedTriangle clipped =
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
        const ClippedTriangle clipped = clip(cap, plane, above);
        for (int i = 2; i < clipped.count; ++i)
            part.caps.push_back({clipped.corners[0], clipped.corners[i - 1], clipped.corners[i]});
        close(clipped);
    }
    return part;
}

}  // namespace sherd
