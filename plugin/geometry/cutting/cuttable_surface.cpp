#include "geometry/cutting/cuttable_surface.h"

namespace sherd {

namespace {

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
      is_closed_(isClosedAndOriented(mesh.triangles, edges_)) {}

}  // namespace sherd
