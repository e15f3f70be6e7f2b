#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// The largest distance of a point of `from` to the nearest one of `to`, m: the one-sided Hausdorff distance,
/// short of the true one by `tolerance` (m) at most. The triangles of `to` have areas.
double largestDistance(const TriangleMesh& from, const TriangleMesh& to, double tolerance);

}  // namespace sherd
