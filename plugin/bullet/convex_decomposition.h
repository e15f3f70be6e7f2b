#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "convex_hull.h"

namespace sherd {

struct DecompositionLimits {
    int most_parts = 24;
    int most_vertices = 32;  ///< of a part
    double air_share =
        0.02;  ///< of the solid's volume: parts whose hulls hold less that is not solid are not cut
};

/// Hulls that together follow a solid: cut in two by planes across the axes, the part with most air in its
/// hull first, each where the hulls of the halves are smallest, and each hull around what the surface bounds
/// there. `surface` is closed and oriented outward; details finer than `smallest_detail_m` count as one
/// point. Approximate convex decomposition (Lien and Amato 2004) by volume, with axis-aligned cuts.
std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double smallest_detail_m,
                                            const DecompositionLimits& limits = {});

}  // namespace sherd
