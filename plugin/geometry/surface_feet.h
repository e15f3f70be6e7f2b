#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// The point of a surface that is nearest to another one.
struct SurfaceFoot {
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 normal = Vec3::Zero();    ///< outward, unit; zero near an edge or a corner, where there is none
    double distance = 0;           ///< m
    int triangle = -1;             ///< that it lies on
    bool outside = false;          ///< whether the other point lies beyond the surface
};

/// Of each of `points`, #points. Facets within `tolerance` of a foot have to lie on one smooth side for it to
/// have a normal.
std::vector<SurfaceFoot> surfaceFeet(const TriangleMesh& mesh, const std::vector<Vec3>& points,
                                     double tolerance);

}  // namespace sherd
