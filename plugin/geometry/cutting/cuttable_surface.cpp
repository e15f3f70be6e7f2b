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

std::vector<TriangleBox> boxesOf(const TriangleMesh& mesh, std::size_t run_length) {
    std::vector<TriangleBox> boxes((mesh.triangles.size() + run_length - 1) / run_length);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        boxes[t / run_length].extend(boxOf(mesh.triangles[t], mesh.vertices));
    return boxes;
}

}  // namespace

CuttableSurface::CuttableSurface(const TriangleMesh& mesh)
    : mesh_(mesh),
      edges_(buildEdgeTable(mesh.triangles, static_cast<int>(mesh.vertices.size()))),
      is_closed_(isClosedAndOriented(mesh.triangles, edges_)),
      boxes_of_runs_(boxesOf(mesh, run_length)) {}

}  // namespace sherd
