#include "geometry/cutting/side_spreading.h"

#include "core/numerics/union_find.h"

namespace sherd {

namespace {

/// The parts of crossed triangles and their edges. The edges of all other triangles are those of the surface
/// before it was split.
struct PartEdges {
    std::vector<int> parts;  // indices into the split surface
    EdgeTable edges;         // triangle k of it is parts[k]
};

PartEdges findPartEdges(const CrossedSurface& surface, const SplitSurface& split, int point_count) {
    PartEdges result;
    std::vector<Triangle> triangles;
    for (std::size_t t = 0; t < split.triangles.size(); ++t) {
        if (surface.groups.isEmpty(split.parents[t])) continue;
        result.parts.push_back(static_cast<int>(t));
        triangles.push_back(split.triangles[t]);
    }
    result.edges = buildEdgeTable(triangles, point_count);
    return result;
}

/// Sets of triangles that are connected without crossing a segment (`is_barrier`: #edges of the parts).
UnionFind connectWithin(const CrossedSurface& surface, const SplitSurface& split, const PartEdges& part_edges,
                        const std::vector<char>& is_barrier) {
    UnionFind sets(split.triangles.size());
    const auto& [parts, edges] = part_edges;
    for (std::size_t e = 0; e < edges.edges.size(); ++e)
        if (!is_barrier[e])
            for (int u = edges.first_use[e] + 1; u < edges.first_use[e + 1]; ++u)
                sets.unite(parts[edges.uses[u] / 3], parts[edges.uses[edges.first_use[e]] / 3]);
    // A triangle that is not crossed has no crossing on its edges, so a split neighbour has a part with the
    // same edge.
    for (std::size_t e = 0; e < surface.edges.edges.size(); ++e) {
        int first = -1;
        for (int u = surface.edges.first_use[e]; u < surface.edges.first_use[e + 1]; ++u) {
            const int parent = surface.edges.uses[u] / 3;
            int t = split.first_part[parent];
            if (!surface.groups.isEmpty(parent)) {
                const Triangle& corners = surface.triangles[parent];
                const int i = surface.edges.uses[u] % 3, edge = edges.find(corners[i], corners[(i + 1) % 3]);
                if (edge < 0) break;
                t = parts[edges.uses[edges.first_use[edge]] / 3];
            }
            if (first >= 0) sets.unite(first, t);
            first = t;
        }
    }
    return sets;
}

}  // namespace

std::optional<SpreadValues> spreadFromSegments(const CrossedSurface& surface, const SplitSurface& split,
                                               int point_count, const std::vector<CutSegment>& segments,
                                               const std::vector<SideValues>& values) {
    const PartEdges part_edges = findPartEdges(surface, split, point_count);
    const auto& [parts, edges] = part_edges;
    std::vector<char> is_barrier(edges.edges.size(), false);
    std::vector<int> edge_of(segments.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
        edge_of[s] = edges.find(segments[s].source, segments[s].target);
        if (edge_of[s] < 0 || edges.first_use[edge_of[s] + 1] - edges.first_use[edge_of[s]] != 2) return {};
        is_barrier[edge_of[s]] = true;
    }
    UnionFind sets = connectWithin(surface, split, part_edges, is_barrier);
    std::vector<int> of_set(split.triangles.size(), -1);
    for (std::size_t s = 0; s < segments.size(); ++s)
        for (int u = edges.first_use[edge_of[s]]; u < edges.first_use[edge_of[s] + 1]; ++u) {
            const int t = parts[edges.uses[u] / 3];
            const bool on_left = split.triangles[t][edges.uses[u] % 3] == segments[s].source;
            const int wanted = on_left ? values[s].left : values[s].right;
            int& known = of_set[sets.root(t)];
            if (known >= 0 && known != wanted) return {};
            known = wanted;
        }
    SpreadValues result = {{}, sets.roots()};
    for (const int set : result.set) result.value.push_back(of_set[set]);
    return result;
}

}  // namespace sherd
