#include "geometry/cutting/cuttable_surface.h"

#include <algorithm>

namespace sherd {

namespace {

constexpr int block_size = 32;  // triangles

bool isClosedAndOriented(const std::vector<Triangle>& triangles, const EdgeTable& edges) {
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        const int first = edges.first_use[e];
        const auto start = [&](int half_edge) { return triangles[half_edge / 3][half_edge % 3]; };
        if (edges.first_use[e + 1] - first != 2 || start(edges.uses[first]) == start(edges.uses[first + 1]))
            return false;
    }
    return true;
}

}  // namespace

CuttableSurface::CuttableSurface(const TriangleMesh& mesh)
    : mesh_(mesh),
      edges_(buildEdgeTable(mesh.triangles, static_cast<int>(mesh.vertices.size()))),
      is_closed_(isClosedAndOriented(mesh.triangles, edges_)) {
    const int count = static_cast<int>(mesh.triangles.size());
    block_boxes_.resize(static_cast<std::size_t>((count + block_size - 1) / block_size));
    for (int t = 0; t < count; ++t)
        for (const int v : mesh.triangles[t]) block_boxes_[t / block_size].extend(mesh.vertices[v]);
}

int CuttableSurface::blockBegin(int block) const {
    return std::min(block * block_size, static_cast<int>(mesh_.triangles.size()));
}

}  // namespace sherd
