#pragma once

#include <sherd/result.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// A quadrature point of a part of the surface.
struct AreaPoint {
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 area = Vec3::Zero();      ///< area times the outward unit normal, m^2
    double area_m2 = 0;            ///< its norm, or a little more where points of a curved part were merged
};

/// Quadrature points of the part of `surface` that lies in `region`, about `size` m apart (closer if the
/// region is small, further apart if there would be thousands). Triangles across the region's border are
/// clipped; the points add up to the region's area to 0.1 %, and integrate linear functions over it exactly.
/// The error says that the region is malformed, or that it touches no surface.
Result<std::vector<AreaPoint>> regionQuadrature(const TriangleMesh& surface, const SurfaceRegion& region,
                                                double size);

/// How large parts of a surface are, and how far they spread.
class AreaSpread {
  public:
    /// `origin`: near the surfaces.
    explicit AreaSpread(const Vec3& origin) : origin_(origin) {}

    /// Adds the part of `surface` that lies in `region`, if any does.
    void add(const TriangleMesh& surface, const SurfaceRegion& region);

    double area_m2() const { return area_; }
    /// The shorter side of a rectangle that spreads as far, m; 0 of no area, and of what lies along a line.
    double width_m() const;

  private:
    Vec3 origin_;
    double area_ = 0;
    Vec3 first_ = Vec3::Zero();   ///< about the origin, m^3
    Mat3 second_ = Mat3::Zero();  ///< m^4
};

/// Of one region.
AreaSpread spreadOf(const TriangleMesh& surface, const SurfaceRegion& region);

/// The forces of a load at the quadrature points of its region: F a / A - p a n at a point of area a and
/// normal n, with A the sum of all areas.
std::vector<PointForce> pointForces(const SurfaceLoad& load, const std::vector<AreaPoint>& points);

}  // namespace sherd
