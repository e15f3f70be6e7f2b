#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "bullet/convex_hull.h"

namespace sherd {

struct DecompositionLimits {
    int most_parts = 24;
    int most_vertices = 96;  ///< of a part
    /// Parts whose hull has less empty volume than this share of the solid's volume are not cut further.
    double air_share = 0.04;
};

/// Approximate convex decomposition (Lien and Amato 2004) by volume, with axis-aligned cuts: the part whose
/// hull has the largest empty volume is cut first, where the hulls of its halves have the least volume. Each
/// hull encloses the surface of its part. `surface` is closed and oriented outward; vertices nearer than
/// about `smallest_detail_m` are merged.
std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double smallest_detail_m,
                                            const DecompositionLimits& limits = {});

}  // namespace sherd
