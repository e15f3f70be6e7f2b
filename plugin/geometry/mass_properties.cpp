#include "geometry/mass_properties.h"

#include "core/numerics/mesh_measures.h"

namespace sherd {
namespace {

/// Sums over the tetrahedra (origin, a, b, c) of all triangles. Their signed volumes cancel outside the
/// solid.
struct TetrahedronSums {
    double volume = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
};

TetrahedronSums sumTetrahedra(const TriangleMesh& mesh, const Vec3& origin) {
    TetrahedronSums sums;
    for (const auto& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices[triangle[0]] - origin;
        const Vec3 b = mesh.vertices[triangle[1]] - origin;
        const Vec3 c = mesh.vertices[triangle[2]] - origin;
        const double volume = a.dot(b.cross(c)) / 6;
        const Vec3 sum = a + b + c;
        sums.volume += volume;
        sums.first += volume / 4 * sum;
        // Exact for quadratics: V/20 (sum over the corners of x x^T, plus the sum of corners times itself).
        sums.second +=
            volume / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    }
    return sums;
}

}  // namespace

Moments solidMoments(const TriangleMesh& mesh) {
    Moments moments;
    if (mesh.triangles.empty()) return moments;
    // Two passes, so that a body far from the origin loses no digits: the second is about the centroid
    // itself.
    const Vec3 near = boundingBox(mesh.vertices).center();
    const TetrahedronSums rough = sumTetrahedra(mesh, near);
    if (rough.volume == 0) {
        moments.centroid = near;
        return moments;
    }
    const Vec3 centroid = near + rough.first / rough.volume;
    const TetrahedronSums sums = sumTetrahedra(mesh, centroid);
    const Vec3 rest = sums.first / sums.volume;
    moments.volume = sums.volume;
    moments.centroid = centroid + rest;
    moments.second = sums.second - sums.volume * rest * rest.transpose();
    return moments;
}

}  // namespace sherd
