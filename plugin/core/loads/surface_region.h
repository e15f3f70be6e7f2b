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

/// How large the part of a surface in a region is.
struct RegionExtent {
    double area_m2 = 0;
    double width_m = 0;  ///< the shorter side of a rectangle that spreads as far
};

/// Both 0 if no part of `surface` lies in `region`.
RegionExtent extentOf(const TriangleMesh& surface, const SurfaceRegion& region);

/// The forces of a load at the quadrature points of its region: F a / A - p a n at a point of area a and
/// normal n, with A the sum of all areas.
std::vector<PointForce> pointForces(const SurfaceLoad& load, const std::vector<AreaPoint>& points);

}  // namespace sherd
