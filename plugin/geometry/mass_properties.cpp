#include "geometry/mass_properties.h"

#include "core/numerics/mesh_measures.h"

namespace sherd {
namespace {

/// Visits the tetrahedra (origin, a, b, c) of all triangles, corners relative to the origin. Their signed
/// volumes cancel outside the solid.
template <class Visit>
void forEachTetrahedron(const TriangleMesh& mesh, const Vec3& origin, const Visit& visit) {
    for (const auto& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices[triangle[0]] - origin;
        const Vec3 b = mesh.vertices[triangle[1]] - origin;
        const Vec3 c = mesh.vertices[triangle[2]] - origin;
        visit(a, b, c, a.dot(b.cross(c)) / 6);
    }
}

struct FirstMoments {
    double volume = 0;
    Vec3 first = Vec3::Zero();

    void add(double tetrahedron, const Vec3& corner_sum) {
        volume += tetrahedron;
        first += tetrahedron / 4 * corner_sum;
    }
};

FirstMoments sumFirst(const TriangleMesh& mesh, const Vec3& origin) {
    FirstMoments sums;
    forEachTetrahedron(mesh, origin, [&](const Vec3& a, const Vec3& b, const Vec3& c, double volume) {
        sums.add(volume, a + b + c);
    });
    return sums;
}

FirstMoments sumFirstAndSecond(const TriangleMesh& mesh, const Vec3& origin, Mat3& second) {
    FirstMoments sums;
    second = Mat3::Zero();
    forEachTetrahedron(mesh, origin, [&](const Vec3& a, const Vec3& b, const Vec3& c, double volume) {
        const Vec3 sum = a + b + c;
        sums.add(volume, sum);
        // Exact for quadratics: V/20 (sum over the corners of x x^T, plus the sum of corners times itself).
        const double weight = volume / 20;
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i <= j; ++i)
                second(i, j) += weight * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sum[i] * sum[j]);
    });
    second.triangularView<Eigen::StrictlyLower>() = second.transpose();
    return sums;
}

}  // namespace

Moments solidMoments(const TriangleMesh& mesh) {
    Moments moments;
    if (mesh.triangles.empty()) return moments;
    // Two passes, so that a body far from the origin loses no digits: the second is about the centroid
    // itself.
    const Vec3 near = boundingBox(mesh.vertices).center();
    const FirstMoments rough = sumFirst(mesh, near);
    if (rough.volume == 0) {
        moments.centroid = near;
        return moments;
    }
    const Vec3 centroid = near + rough.first / rough.volume;
    const FirstMoments sums = sumFirstAndSecond(mesh, centroid, moments.second);
    const Vec3 rest = sums.first / sums.volume;
    moments.volume = sums.volume;
    moments.centroid = centroid + rest;
    moments.second -= sums.volume * rest * rest.transpose();
    return moments;
}

}  // namespace sherd
