#include "geometry/cutting/split_surface.h"

#include <algorithm>
#include <utility>

#include "geometry/cutting/triangle_subdivision.h"

namespace sherd {

namespace {

/// Corners of a triangle and crossings along its edges, counter-clockwise. `crossings`: scratch memory.
void collectLoop(const CrossedSurface& surface, int triangle, std::vector<int>& loop,
                 std::vector<EdgeCrossing>& crossings) {
    loop.clear();
    for (int i = 0; i < 3; ++i) {
        const int edge = surface.edges.of_triangle[triangle][i];
        surface.on_edges.collect(edge, crossings);
        loop.push_back(surface.triangles[triangle][i]);
        const auto first = static_cast<long>(loop.size());
        for (const EdgeCrossing& crossing : crossings) loop.push_back(crossing.point);
        const bool from_lower = surface.triangles[triangle][i] < surface.triangles[triangle][(i + 1) % 3];
        if (!from_lower) std::reverse(loop.begin() + first, loop.end());
    }
}

}  // namespace

SegmentGroups groupSegments(const std::vector<CutSegment>& segments, int CutSegment::*triangle,
                            std::size_t count) {
    SegmentGroups groups;
    groups.first.assign(count + 1, 0);
    for (const CutSegment& s : segments) ++groups.first[s.*triangle + 1];
    for (std::size_t t = 1; t <= count; ++t) groups.first[t] += groups.first[t - 1];
    groups.segments.resize(segments.size());
    std::vector<int> next(groups.first.begin(), groups.first.end() - 1);
    for (std::size_t s = 0; s < segments.size(); ++s)
        groups.segments[next[segments[s].*triangle]++] = static_cast<int>(s);
    return groups;
}

SplitSurface splitSurface(const CrossedSurface& surface, const SurfaceCrossing& crossing,
                          std::vector<int>& troubled) {
    SplitSurface result;
    result.triangles.reserve(surface.triangles.size() + 2 * crossing.points.size());
    result.first_part.reserve(surface.triangles.size() + 1);
    TriangleSubdivision subdivision;
    std::vector<std::pair<int, int>> pairs;
    std::vector<int> loop;
    std::vector<EdgeCrossing> crossings;
    const std::vector<Vec3>& x = crossing.points;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        result.first_part.push_back(static_cast<int>(result.triangles.size()));
        if (surface.groups.isEmpty(t)) {
            result.triangles.push_back(surface.triangles[t]);
            continue;
        }
        pairs.clear();
        const auto begin = surface.groups.segments.begin() + surface.groups.first[t],
                   end = surface.groups.segments.begin() + surface.groups.first[t + 1];
        for (auto s = begin; s != end; ++s)
            pairs.emplace_back(crossing.segments[*s].source, crossing.segments[*s].target);
        const auto& [a, b, c] = surface.triangles[t];
        collectLoop(surface, t, loop, crossings);
        if (!subdivision.split(x, (x[b] - x[a]).cross(x[c] - x[a]), loop, pairs, result.triangles))
            for (auto s = begin; s != end; ++s) troubled.push_back(crossing.segments[*s].crack_triangle);
    }
    result.first_part.push_back(static_cast<int>(result.triangles.size()));
    result.parents.resize(result.triangles.size());
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
        std::fill(result.parents.begin() + result.first_part[t],
                  result.parents.begin() + result.first_part[t + 1], t);
    return result;
}

}  // namespace sherd
