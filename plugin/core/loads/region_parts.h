#pragma once

#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// Corners in order, counter-clockwise seen from outside the body.
using ConvexPolygon = std::vector<Vec3>;

/// What is left of each triangle of `surface` inside `region`, empty parts left out. The region is one that
/// `checkRegion` accepts.
std::vector<ConvexPolygon> partsInside(const TriangleMesh& surface, const SurfaceRegion& region);

double areaOf(const ConvexPolygon& polygon);

}  // namespace sherd
