#include "viewer/body_meshes.h"

#include <array>
#include <vector>

#include "headless/corner_normals.h"

namespace demo {
namespace {
constexpr double crease_deg = 50;
}  // namespace

render::MeshData toMeshData(const sherd::TriangleMesh& surface) {
    const auto normals = cornerNormals(surface, crease_deg);
    render::MeshData data;
    data.corners.reserve(3 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = std::size_t(surface.triangles[t][k]);
            render::Vertex corner;
            corner.position = surface.vertices[v].cast<float>();
            corner.normal = normals[t][k].cast<float>();
            if (!surface.colours.empty()) corner.colour = surface.colours[v].cast<float>();
            corner.inside = !surface.kinds.empty() && surface.kinds[t] == sherd::SurfaceKind::crack;
            data.corners.push_back(corner);
        }
    return data;
}

const render::Mesh& BodyMeshes::of(const sherd::BreakableAsset& asset) {
    const auto [entry, is_new] = entries_.try_emplace(&asset.surface(), Entry{asset, nullptr, true});
    if (is_new) entry->second.mesh = std::make_unique<render::Mesh>(toMeshData(asset.surface()));
    entry->second.used = true;
    return *entry->second.mesh;
}

void BodyMeshes::endFrame() {
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const bool used = std::exchange(entry->second.used, false);
        entry = used ? std::next(entry) : entries_.erase(entry);
    }
}

}  // namespace demo
