#pragma once

#include <sherd/triangle_mesh.h>
#include <sherd/types.h>

#include <vector>

namespace sherd {

/// Where a contact point of the collision shape lies on the true surface.
struct SurfaceSpot {
    Vec3 point = Vec3::Zero();  ///< nearest point of the surface, m
    int triangle = -1;
};

/// Nearest point of those triangles that face the push (outward normal against `push`), or of all if none
/// does.
SurfaceSpot nearestSurfacePoint(const TriangleMesh& surface, const Vec3& point, const Vec3& push);

/// Radius of curvature that the surface shows a flat partner at `spot`: the sphere whose cap of height
/// `depth` has as much area, A = 2 pi R depth, as the surface has within `reach` of the spot and `depth` of
/// its furthest point against the push. Faces give a large radius, edges and corners a small one.
double contactRadius(const TriangleMesh& surface, const Vec3& spot, const Vec3& push, double reach,
                     double depth);

/// A total `force` spread as a uniform traction over the surface within `radius` of `spot` that faces the
/// push: quadrature points whose forces add up to it.
std::vector<PointForce> spreadForce(const TriangleMesh& surface, const SurfaceSpot& spot, const Vec3& push,
                                    double radius, const Vec3& force);

}  // namespace sherd
