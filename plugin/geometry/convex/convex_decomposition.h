#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "geometry/convex/convex_hull.h"

namespace sherd {

struct DecompositionLimits {
    int most_parts = 24;
    int most_vertices = 96;  ///< of a part
    /// Parts are not cut if the volume in their hulls that is not solid is at most this part of the solid's.
    double air_share = 0.01;
    /// The solid is not cut at all if the volume in its hull that is not solid is at most this part of it.
    double air_share_of_one_hull = 0.04;
    /// Vertices of the surface may lie that far outside the hulls, where the number of vertices allows it.
    double tolerance_m = 0;
};

/// Convex hulls that together follow a solid. The solid is cut in two by a plane across an axis, then always
/// the part with most air in its hull, each where the two halves are most compact and their hulls smallest.
/// `surface` is closed and encloses `volume`, m^3. Approximate convex decomposition (Lien and Amato 2004) by
/// volume, with axis-aligned cuts. The work is that of at most most_parts - 1 cuts.
std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double volume,
                                            const DecompositionLimits& limits = {});

}  // namespace sherd
