#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "bullet/convex_hull.h"

namespace sherd {

struct DecompositionLimits {
    int most_parts = 24;
    int most_vertices = 96;  ///< of a part
    /// Parts are not cut if the volume in their hulls that is not solid is at most this part of the solid's.
    double air_share = 0.04;
};

/// Convex hulls that together follow a solid. The solid is cut in two by a plane across an axis, then always
/// the part with most air in its hull, each where the hulls of the two halves are smallest. `surface` is
/// closed and oriented outward; details finer than `smallest_detail_m` count as one point. Approximate convex
/// decomposition (Lien and Amato 2004) by volume, with axis-aligned cuts.
std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double smallest_detail_m,
                                            const DecompositionLimits& limits = {});

}  // namespace sherd
