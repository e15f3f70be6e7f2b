#pragma once

#include <sherd/triangle_mesh.h>

#include <array>

namespace sherd {

/// The corners of a triangle in space, m.
using TriangleCorners = std::array<Vec3, 3>;

inline TriangleCorners cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Area of a triangle times its unit normal, m^2.
inline Vec3 areaVector(const TriangleCorners& t) {
    return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
}

/// Of all triangles together, m^2.
inline double surfaceArea(const TriangleMesh& mesh) {
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += areaVector(cornersOf(mesh, t)).norm();
    return area;
}

inline Eigen::AlignedBox3d boundingBox(const std::vector<Vec3>& points) {
    Eigen::AlignedBox3d box;
    for (const Vec3& x : points) box.extend(x);
    return box;
}

/// Of all triangles; vertices that belong to none do not count.
inline Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) box.extend(mesh.vertices[corner]);
    return box;
}

/// Volume enclosed by triangles whose corners are indices into `points`, m^3; exact up to rounding if
/// `origin` is near. Negative where the triangles face inward.
inline double enclosedVolume(const std::vector<Vec3>& points,
                             const std::vector<std::array<int, 3>>& triangles, const Vec3& origin) {
    double six_volumes = 0;
    for (const auto& [a, b, c] : triangles)
        six_volumes += (points[a] - origin).cross(points[b] - origin).dot(points[c] - origin);
    return six_volumes / 6;
}

}  // namespace sherd
