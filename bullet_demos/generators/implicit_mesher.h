#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <Eigen/Dense>
#include <functional>

namespace sherd::generators {

struct MeshFineness {
    double triangle_radius = 1e-3;   ///< largest radius of a triangle's surrounding ball, m
    double surface_distance = 5e-5;  ///< largest distance of a triangle from the surface, m
    int smoothing_rounds = 8;
};

struct ImplicitSolid {
    std::function<double(const Eigen::Vector3d&)>
        distance;                                           ///< about the signed distance, m, negative inside
    Eigen::Vector3d inner_point = Eigen::Vector3d::Zero();  ///< anywhere inside
    double bounding_radius = 1;  ///< of a ball around inner_point that holds the solid, m
    MeshFineness fineness;       ///< that shows its form well
};

/// A closed surface with even triangles (CGAL's Delaunay surface mesher, then smoothing along the surface).
/// Coordinates are rounded to 1e-8 m, so that the file is short.
Result<TriangleMesh> meshImplicitSolid(const ImplicitSolid& solid, const MeshFineness& fineness);

/// The same in `triangles` triangles within 1 %, from 2000 to 1,000,000. The error names the nearest number
/// that was reached.
Result<TriangleMesh> meshWithCount(const ImplicitSolid& solid, int triangles);

}  // namespace sherd::generators
