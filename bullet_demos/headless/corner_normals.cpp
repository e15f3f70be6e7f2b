#include "headless/corner_normals.h"

#include <algorithm>
#include <cmath>

namespace demo {
namespace {

using sherd::SurfaceKind;
using sherd::TriangleMesh;
using sherd::Vec3;

bool isCrack(const TriangleMesh& mesh, std::size_t triangle) {
    return !mesh.kinds.empty() && mesh.kinds[triangle] == SurfaceKind::crack;
}

/// Normals times twice the area: large triangles then weigh more in the averages.
std::vector<Vec3> areaNormals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals;
    for (const auto& [a, b, c] : mesh.triangles) {
        normals.push_back((mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]));
    }
    return normals;
}

Vec3 unit(const Vec3& v) {
    return v.squaredNorm() > 0 ? v.normalized().eval() : Vec3::UnitZ().eval();
}

}  // namespace

std::vector<std::array<Vec3, 3>> cornerNormals(const TriangleMesh& mesh, double crease_deg) {
    const double least_cosine = std::cos(crease_deg * 3.14159265358979323846 / 180);
    const std::vector<Vec3> faces = areaNormals(mesh);
    std::vector<std::vector<std::size_t>> around(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (isCrack(mesh, t)) continue;
        for (int v : mesh.triangles[t]) around[v].push_back(t);
    }
    std::vector<std::array<Vec3, 3>> corners(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 own = unit(faces[t]);
        corners[t].fill(own);
        if (isCrack(mesh, t)) continue;
        for (int k = 0; k < 3; ++k) {
            Vec3 sum = Vec3::Zero();
            for (std::size_t other : around[mesh.triangles[t][k]]) {
                if (unit(faces[other]).dot(own) >= least_cosine) sum += faces[other];
            }
            corners[t][k] = sum.squaredNorm() > 0 ? unit(sum) : own;
        }
    }
    return corners;
}

}  // namespace demo
