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

/// A region as part of a surface: what lies on it is told by the same triangles and tolerances that place its
/// loads.
class RegionOnSurface {
  public:
    RegionOnSurface(const TriangleMesh& surface, const SurfaceRegion& region);

    /// Whether a point of a triangle lies in the region.
    bool holds(int triangle, const Vec3& x) const;

    /// Whether a point within `reach` of the surface may lie over the region; costs next to nothing.
    bool mayHold(const Vec3& x, double reach) const;

  private:
    SurfaceRegion region_;
    double tolerance_;
    std::vector<char> has_part_;  // #triangles
};

double areaOf(const ConvexPolygon& polygon);

}  // namespace sherd
