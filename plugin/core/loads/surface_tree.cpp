#include "core/loads/surface_tree.h"

#include "core/numerics/mesh_measures.h"

namespace sherd {

namespace {

constexpr int largest_leaf = 8;  // triangles

// Rounding in the distance to a box must not hide a triangle in it that is just as near.
constexpr double slack = 1e-12;  // of the surface's size

// Of the area that parts of one plane may lose against the sum of their triangles', which face a little
// otherwise: two that meet under 7 degrees, or a surface that is rough by 4.
constexpr double lost_if_flat = 2e-3;

}  // namespace

/// A triangle to be put into the tree. Numbers that are looked at together lie together.
struct SurfaceTree::Item {
    Vec3 centre;
    int triangle;
};

/// Of the triangles of a node.
struct SurfaceTree::Sums {
    Vec3 area = Vec3::Zero(), moment = Vec3::Zero();  ///< moment: of their sizes
    double size = 0;

    void operator+=(const Sums& other) {
        area += other.area;
        moment += other.moment;
        size += other.size;
    }
};

SurfaceTree::SurfaceTree(const TriangleMesh& surface) : surface_(surface) {
    std::vector<Item> items;
    items.reserve(surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles)
        items.push_back({(surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3,
                         static_cast<int>(items.size())});
    nodes_.reserve(items.size() / 2 + 1);
    if (items.empty()) return;
    Sums whole;
    build(0, static_cast<int>(items.size()), items, whole);
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

int SurfaceTree::build(int begin, int end, std::vector<Item>& items, Sums& sums) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, begin, end});
    if (end - begin <= largest_leaf) {
        for (int i = begin; i < end; ++i) {
            const TriangleCorners corners = cornersOf(surface_, items[i].triangle);
            for (const Vec3& corner : corners) nodes_[index].box.extend(corner);
            const Vec3 area = areaVector(corners);
            sums += {area, area.norm() * items[i].centre, area.norm()};
        }
    } else {
        Eigen::AlignedBox3d middles;
        for (int i = begin; i < end; ++i) middles.extend(items[i].centre);
        int axis = 0;
        middles.sizes().maxCoeff(&axis);
        const int half = split(begin, end, axis, middles.center()[axis], items);
        Sums second;
        const int left = build(begin, half, items, sums), right = build(half, end, items, second);
        sums += second;
        nodes_[index].right = right;
        nodes_[index].box = nodes_[left].box.merged(nodes_[right].box);
    }
    Node& node = nodes_[index];
    node.is_flat = sums.area.norm() > (1 - lost_if_flat) * sums.size;
    node.area = sums.area.cast<float>();
    node.centre = (sums.size > 0 ? Vec3(sums.moment / sums.size) : node.box.center()).cast<float>();
    return index;
}

std::vector<int> SurfaceTree::trianglesNear(const Vec3& point, double radius) const {
    return trianglesWhere([&](const Eigen::AlignedBox3d& box) {
        return box.squaredExteriorDistance(point) <= radius * radius;
    });
}

}  // namespace sherd
