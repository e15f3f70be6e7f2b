#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// The point of a surface that is nearest to a given one.
struct SurfaceFoot {
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 normal = Vec3::Zero();    ///< outward, unit; zero near an edge or a corner
    double distance = 0;           ///< m
    int triangle = -1;             ///< that it lies on
    bool outside = false;          ///< whether the given point lies outside of the surface
};

/// The feet of `points`, #points. A foot has a normal if all triangles within `tolerance` of it (m) lie on
/// one smooth side.
std::vector<SurfaceFoot> surfaceFeet(const TriangleMesh& mesh, const std::vector<Vec3>& points,
                                     double tolerance);

}  // namespace sherd
