#pragma once

#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// Corners in order, counter-clockwise seen from outside the body.
using ConvexPolygon = std::vector<Vec3>;

/// The part of each triangle of `surface` inside `region`, empty parts left out. `region` must be one that
/// `checkRegion` accepts.
std::vector<ConvexPolygon> partsInside(const TriangleMesh& surface, const SurfaceRegion& region);

/// Tells whether points lie in a region of a surface, with the same triangles and tolerances by which
/// `partsInside` places the region's loads.
class RegionOnSurface {
  public:
    RegionOnSurface(const TriangleMesh& surface, const SurfaceRegion& region);

    /// Whether a point of a triangle lies in the region.
    bool holds(int triangle, const Vec3& x) const;

    /// A quick test: false only if no point of the region's surface lies within `reach` of x.
    bool mayHold(const Vec3& x, double reach) const;

  private:
    SurfaceRegion region_;
    double tolerance_;
    std::vector<char> has_part_;  // #triangles
};

double areaOf(const ConvexPolygon& polygon);  ///< m^2

}  // namespace sherd
