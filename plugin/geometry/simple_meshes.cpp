#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cmath>

#include "core/numerics/pi.h"

namespace sherd {

TriangleMesh boxMesh(const Vec3& size_m) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back(
            (Vec3(corner & 1, corner >> 1 & 1, corner >> 2) - Vec3::Constant(0.5)).cwiseProduct(size_m));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TriangleMesh cylinderMesh(double radius_m, double height_m, int sides) {
    const int count = std::max(3, sides), below = 2 * count, above = below + 1;
    TriangleMesh mesh;
    for (const double z : {-height_m / 2, height_m / 2})
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * pi * i / count;
            mesh.vertices.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle), z);
        }
    for (const double z : {-height_m / 2, height_m / 2}) mesh.vertices.emplace_back(0, 0, z);
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        mesh.triangles.push_back({i, next, count + i});
        mesh.triangles.push_back({next, count + next, count + i});
        mesh.triangles.push_back({below, next, i});
        mesh.triangles.push_back({above, count + i, count + next});
    }
    return mesh;
}

}  // namespace sherd
