#include "geometry/cutting/cuttable_surface.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/numerics/mesh_measures.h"

namespace sherd {

namespace {

constexpr int block_size = 32;  // triangles

/// The bits of a number of `bits` bits, each followed by two zeros.
std::uint64_t spread(std::uint64_t number, int bits) {
    std::uint64_t wide = 0;
    for (int b = 0; b < bits; ++b) wide |= (number >> b & 1) << 3 * b;
    return wide;
}

/// The triangles along Morton's curve through their middles.
std::vector<int> alongACurve(const TriangleMesh& mesh) {
    constexpr int bits = 10;  // a thousandth of the body
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    const double cells = (1 << bits) - 1, size = std::max(box.sizes().maxCoeff(), 1e-300);
    std::vector<std::pair<std::uint64_t, int>> places;
    places.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const TriangleCorners corners = cornersOf(mesh, t);
        const Vec3 at = ((corners[0] + corners[1] + corners[2]) / 3 - box.min()) * (cells / size);
        std::uint64_t place = 0;
        for (int d = 0; d < 3; ++d)
            place |= spread(static_cast<std::uint64_t>(std::clamp(at[d], 0.0, cells)), bits) << d;
        places.emplace_back(place, static_cast<int>(t));
    }
    std::sort(places.begin(), places.end());
    std::vector<int> order;
    order.reserve(places.size());
    for (const auto& [place, triangle] : places) order.push_back(triangle);
    return order;
}

std::vector<Eigen::AlignedBox3d> boxesOfBlocks(const TriangleMesh& mesh, const std::vector<int>& order) {
    std::vector<Eigen::AlignedBox3d> boxes((order.size() + block_size - 1) / block_size);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (const int v : mesh.triangles[order[i]]) boxes[i / block_size].extend(mesh.vertices[v]);
    return boxes;
}

double sumOfDiagonals(const std::vector<Eigen::AlignedBox3d>& boxes) {
    double sum = 0;
    for (const Eigen::AlignedBox3d& box : boxes) sum += box.diagonal().norm();
    return sum;
}

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
      is_closed_(isClosedAndOriented(mesh.triangles, edges_)),
      order_(mesh.triangles.size()) {
    constexpr double better = 0.25;  // rows of triangles do as well: they lie together in memory
    std::iota(order_.begin(), order_.end(), 0);
    block_boxes_ = boxesOfBlocks(mesh, order_);
    std::vector<int> other = alongACurve(mesh);
    std::vector<Eigen::AlignedBox3d> boxes = boxesOfBlocks(mesh, other);
    if (sumOfDiagonals(boxes) < better * sumOfDiagonals(block_boxes_)) {
        order_ = std::move(other);
        block_boxes_ = std::move(boxes);
    }
}

int CuttableSurface::blockBegin(int block) const {
    return std::min(block * block_size, static_cast<int>(order_.size()));
}

}  // namespace sherd
