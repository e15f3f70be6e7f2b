#pragma once

#include <optional>
#include <vector>

#include "geometry/cutting/split_surface.h"

namespace sherd {

/// Values on the two sides of a segment: of the triangle that runs along it from source to target, and of the
/// other one.
struct SideValues {
    int left, right;
};

/// A value for each triangle of a split surface, and the connected set that it belongs to.
struct SpreadValues {
    std::vector<int> value;  ///< #triangles; -1 where no segment bounds the set
    std::vector<int> set;    ///< #triangles; equal within a set, else different
    int set_count = 0;       ///< numbers of sets are below
};

/// Spreads the values beside the segments (`values`: #segments) over the triangles that are connected without
/// crossing a segment. Nothing if two segments disagree about a set.
std::optional<SpreadValues> spreadFromSegments(const CrossedSurface& surface, const SplitSurface& split,
                                               const std::vector<SideValues>& values);

}  // namespace sherd
