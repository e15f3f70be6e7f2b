#include "core/loads/surface_tree.h"

namespace sherd {

namespace {

constexpr int largest_leaf = 8;  // triangles

// Rounding in the distance to a box must not hide a triangle in it that is just as near.
constexpr double slack = 1e-12;  // of the surface's size

}  // namespace

/// A triangle to be put into the tree. Numbers that are looked at together lie together.
struct SurfaceTree::Item {
    Vec3 centre;
    int triangle;
};

SurfaceTree::SurfaceTree(const TriangleMesh& surface) : surface_(surface) {
    std::vector<Item> items;
    items.reserve(surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles)
        items.push_back({(surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3,
                         static_cast<int>(items.size())});
    nodes_.reserve(items.size() / 2 + 1);
    if (items.empty()) return;
    build(0, static_cast<int>(items.size()), items);
    nodes_.shrink_to_fit();  // a body keeps its tree; a third was never needed
    triangles_.reserve(items.size());
    for (const Item& item : items) triangles_.push_back(item.triangle);
    const Vec3 grown = Vec3::Constant(slack * nodes_[0].box.diagonal().norm());
    for (Node& node : nodes_) node.box = {node.box.min() - grown, node.box.max() + grown};
}

/// Parts the items at `middle`, or in two equal halves where that leaves hardly any on one side. Returns the
/// first of the second part.
int SurfaceTree::split(int begin, int end, int axis, double middle, std::vector<Item>& items) {
    const auto first = items.begin() + begin, last = items.begin() + end;
    const auto parted =
        std::partition(first, last, [&](const Item& item) { return item.centre[axis] < middle; });
    constexpr int least_part = 8;  // of a whole
    if (least_part * std::min(parted - first, last - parted) >= last - first)
        return begin + static_cast<int>(parted - first);
    const auto half = first + (last - first) / 2;
    std::nth_element(first, half, last, [&](const Item& a, const Item& b) {
        return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.triangle < b.triangle;
    });
    return begin + static_cast<int>(half - first);
}

int SurfaceTree::build(int begin, int end, std::vector<Item>& items) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, begin, end, 0});
    if (end - begin <= largest_leaf) {
        for (int i = begin; i < end; ++i)
            for (const int corner : surface_.triangles[items[i].triangle])
                nodes_[index].box.extend(surface_.vertices[corner]);
        return index;
    }
    Eigen::AlignedBox3d middles;
    for (int i = begin; i < end; ++i) middles.extend(items[i].centre);
    int axis = 0;
    middles.sizes().maxCoeff(&axis);
    const int half = split(begin, end, axis, middles.center()[axis], items);
    const int left = build(begin, half, items), right = build(half, end, items);
    nodes_[index].right = right;
    nodes_[index].box = nodes_[left].box.merged(nodes_[right].box);
    return index;
}

std::vector<int> SurfaceTree::trianglesNear(const Vec3& point, double radius) const {
    return trianglesWhere([&](const Eigen::AlignedBox3d& box) {
        return box.squaredExteriorDistance(point) <= radius * radius;
    });
}

}  // namespace sherd
