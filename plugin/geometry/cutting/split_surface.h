#pragma once

#include <vector>

#include "geometry/cutting/surface_crossing.h"

namespace sherd {

/// Segments sorted by the triangle that they lie in.
struct SegmentGroups {
    std::vector<int> first;     ///< #T + 1, offsets into `segments`
    std::vector<int> segments;  ///< those of triangle t are entries first[t] to first[t + 1] - 1

    bool isEmpty(int t) const { return first[t] == first[t + 1]; }
};

/// `triangle`: the member that says which of `count` triangles a segment lies in.
SegmentGroups groupSegments(const std::vector<CutSegment>& segments, int CutSegment::*triangle,
                            std::size_t count);

/// One of two surfaces that cross, with points numbered as in `SurfaceCrossing`.
struct CrossedSurface {
    const std::vector<Triangle>& triangles;
    const EdgeTable& edges;
    const EdgeCrossings& on_edges;
    SegmentGroups groups;
};

/// The triangles of a crossed surface, the crossed ones split along their segments.
struct SplitSurface {
    std::vector<Triangle> triangles;
    std::vector<int> parents;  ///< #triangles, the triangle before splitting

    // A patch is a triangle that is not crossed, under its own number, or one of the polygons that a crossed
    // one is cut into: what is connected without a look across its edges.
    std::vector<int> patches;      ///< #triangles
    int patch_count = 0;           ///< with the numbers of crossed triangles, which no patch has
    std::vector<int> crossed;      ///< #parents, the number among the crossed ones, or -1
    std::vector<int> first_side;   ///< 3 #crossed + 1, offsets into `along_sides`
    std::vector<int> along_sides;  ///< patches from corner to corner around crossed triangles
    std::vector<std::array<int, 2>> beside_segments;  ///< #segments, the patches on their left and right
};

/// Splits by constrained Delaunay triangulation. Where that fails the crack triangles to blame are appended
/// to `troubled`.
SplitSurface splitSurface(const CrossedSurface& surface, const SurfaceCrossing& crossing,
                          std::vector<int>& troubled);

}  // namespace sherd
