#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "bullet/convex_hull.h"

namespace sherd {

struct DecompositionLimits {
    int most_parts = 24;
    int most_vertices = 96;  ///< of a part
    /// Of the solid's volume: parts with less in their hulls that is not solid are not cut.
    double air_share = 0.04;
};

/// Hulls that together follow a solid: cut in two by planes across the axes, the part with most air in its
/// hull first, each where the hulls of the halves are smallest, and each hull around what the surface bounds
/// there. `surface` is closed and oriented outward; details finer than `smallest_detail_m` count as one
/// point. Approximate convex decomposition (Lien and Amato 2004) by volume, with axis-aligned cuts.
std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double smallest_detail_m,
                                            const DecompositionLimits& limits = {});

}  // namespace sherd
