#include "geometry/cutting/side_spreading.h"

#include "core/numerics/union_find.h"

namespace sherd {

namespace {

/// The patches of a triangle along one of its edges.
struct AlongEdge {
    const int* begin;
    int count;
    bool from_lower;  // the triangle runs along it from its lower vertex to the higher one
    int operator[](int k) const { return begin[from_lower ? k : count - 1 - k]; }
};

/// `half_edge`: of the surface. `own`: memory for the patch of a triangle that is not crossed.
AlongEdge patchesAlong(const CrossedSurface& surface, const SplitSurface& split, int half_edge, int& own) {
    const int triangle = half_edge / 3, corner = half_edge % 3;
    own = triangle;
    if (split.crossed[triangle] < 0) return {&own, 1, true};
    const int side = 3 * split.crossed[triangle] + corner, first = split.first_side[side];
    const Triangle& t = surface.triangles[triangle];
    return {split.along_sides.data() + first, split.first_side[side + 1] - first,
            t[corner] < t[corner < 2 ? corner + 1 : 0]};
}

/// Sets of patches that are connected without crossing a segment. A triangle that is not crossed has no
/// crossing on its edges, so a split neighbour has one patch there.
UnionFind connectPatches(const CrossedSurface& surface, const SplitSurface& split) {
    UnionFind sets(split.patch_count);
    int patch, other_patch;
    const EdgeTable& edges = surface.edges;
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        const int begin = edges.first_use[e], end = edges.first_use[e + 1];
        const AlongEdge first = patchesAlong(surface, split, edges.uses[begin], patch);
        for (int u = begin + 1; u < end; ++u) {
            const AlongEdge other = patchesAlong(surface, split, edges.uses[u], other_patch);
            if (other.count != first.count) continue;
            for (int k = 0; k < first.count; ++k) sets.unite(first[k], other[k]);
        }
    }
    return sets;
}

}  // namespace

std::optional<SpreadValues> spreadFromSegments(const CrossedSurface& surface, const SplitSurface& split,
                                               const std::vector<SideValues>& values) {
    UnionFind sets = connectPatches(surface, split);
    std::vector<int> of_set(split.patch_count, -1);
    for (std::size_t s = 0; s < values.size(); ++s)
        for (int side = 0; side < 2; ++side) {
            const int wanted = side == 0 ? values[s].left : values[s].right;
            int& known = of_set[sets.root(split.beside_segments[s][side])];
            if (known >= 0 && known != wanted) return {};
            known = wanted;
        }
    SpreadValues result;
    result.set_count = split.patch_count;
    result.set.reserve(split.patches.size());
    result.value.reserve(split.patches.size());
    for (const int patch : split.patches) {
        result.set.push_back(sets.root(patch));
        result.value.push_back(of_set[result.set.back()]);
    }
    return result;
}

}  // namespace sherd
