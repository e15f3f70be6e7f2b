#include "film/drawn_mesh.h"

#include <array>
#include <map>

#include "headless/corner_normals.h"

namespace demo {
namespace {

using sherd::SurfaceKind;
using sherd::Vec3;

constexpr double crease_deg = 40;

/// Of all corners at one vertex of the mesh.
using Known = std::map<std::array<double, 3>, std::uint32_t>;

}  // namespace

DrawnMesh drawnMesh(const sherd::TriangleMesh& mesh) {
    DrawnMesh drawn;
    const std::vector<std::array<Vec3, 3>> normals = cornerNormals(mesh, crease_deg);
    std::vector<Known> known[2] = {std::vector<Known>(mesh.vertices.size()),
                                   std::vector<Known>(mesh.vertices.size())};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const SurfaceKind kind = mesh.kinds.empty() ? SurfaceKind::original : mesh.kinds[t];
        const bool is_crack = kind == SurfaceKind::crack;
        for (int corner = 0; corner < 3; ++corner) {
            const int vertex = mesh.triangles[t][corner];
            const Vec3& normal = normals[t][corner];
            const auto next = static_cast<std::uint32_t>(drawn.vertices.size());
            const auto [found, is_new] =
                known[is_crack][vertex].try_emplace({normal.x(), normal.y(), normal.z()}, next);
            if (is_new) drawn.vertices.push_back({mesh.vertices[vertex], normal, kind});
            (is_crack ? drawn.crack : drawn.outside).push_back(found->second);
        }
    }
    return drawn;
}

}  // namespace demo
