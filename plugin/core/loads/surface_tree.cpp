#include "core/loads/surface_tree.h"

#include <numeric>

namespace sherd {

namespace {

constexpr int largest_leaf = 8;  // triangles

// Rounding in the distance to a box must not hide a triangle in it that is just as near.
constexpr double slack = 1e-12;  // of the surface's size

}  // namespace

SurfaceTree::SurfaceTree(const TriangleMesh& surface) : surface_(surface) {
    std::vector<Vec3> centres;
    centres.reserve(surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles)
        centres.push_back((surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3);
    triangles_.resize(centres.size());
    std::iota(triangles_.begin(), triangles_.end(), 0);
    nodes_.reserve(centres.size() / 2 + 1);
    if (centres.empty()) return;
    build(0, static_cast<int>(triangles_.size()), centres);
    const Vec3 grown = Vec3::Constant(slack * nodes_[0].box.diagonal().norm());
    for (Node& node : nodes_) node.box = {node.box.min() - grown, node.box.max() + grown};
}

int SurfaceTree::build(int begin, int end, const std::vector<Vec3>& centres) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, begin, end, 0});
    Eigen::AlignedBox3d box, middles;
    for (int i = begin; i < end; ++i) {
        for (const int corner : surface_.triangles[triangles_[i]]) box.extend(surface_.vertices[corner]);
        middles.extend(centres[triangles_[i]]);
    }
    nodes_[index].box = box;
    if (end - begin <= largest_leaf) return index;
    int axis = 0;
    middles.sizes().maxCoeff(&axis);
    const int half = (begin + end) / 2;
    std::nth_element(
        triangles_.begin() + begin, triangles_.begin() + half, triangles_.begin() + end, [&](int a, int b) {
            return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
        });
    build(begin, half, centres);
    const int right = build(half, end, centres);
    nodes_[index].right = right;
    return index;
}

std::vector<int> SurfaceTree::trianglesNear(const Vec3& point, double radius) const {
    return trianglesWhere([&](const Eigen::AlignedBox3d& box) {
        return box.squaredExteriorDistance(point) <= radius * radius;
    });
}

}  // namespace sherd
