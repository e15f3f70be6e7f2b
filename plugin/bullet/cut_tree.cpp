#include "bullet/cut_tree.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/plane_crossing.h"

namespace sherd {

namespace {

constexpr int no_leaf = -1;

/// Whether a polygon of the surface is on one side of a plane, at least in part. What lies in the plane is on
/// the side where the solid is.
bool isOn(bool above, const std::vector<Vec3>& polygon, const Vec3& outward, const AxisPlane& plane,
          double tolerance_m) {
    double lowest = 0, highest = 0;
    for (const Vec3& x : polygon) {
        lowest = std::min(lowest, plane.height(x));
        highest = std::max(highest, plane.height(x));
    }
    if (lowest >= -tolerance_m && highest <= tolerance_m) return above == (outward[plane.axis] < 0);
    return above ? highest > tolerance_m : lowest < -tolerance_m;
}

/// The part of a convex polygon on one side of a plane.
std::vector<Vec3> partOf(const std::vector<Vec3>& polygon, const AxisPlane& plane, bool above,
                         double tolerance_m) {
    std::vector<Vec3> part;
    walkAcrossPlane(
        static_cast<int>(polygon.size()), [&](int i) { return plane.height(polygon[i]) >= 0; },
        [&](int i, bool is_above) {
            if (is_above == above || std::abs(plane.height(polygon[i])) <= tolerance_m)
                part.push_back(polygon[i]);
        },
        [&](int i, int next, bool) {
            part.push_back(planeCrossing(polygon[i], plane.height(polygon[i]), polygon[next],
                                         plane.height(polygon[next])));
        });
    return part;
}

}  // namespace

int CutTree::nodeOf(int leaf) const {
    for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (nodes_[n].below < 0 && nodes_[n].leaf == leaf) return static_cast<int>(n);
    return -1;
}

int CutTree::cut(int leaf, const AxisPlane& plane) {
    const int node = nodeOf(leaf), first = static_cast<int>(nodes_.size());
    nodes_[node].plane = plane;
    nodes_[node].below = first;
    nodes_[node].above = first + 1;
    Node below, above;
    below.leaf = leaf;
    above.leaf = leaf_count_;
    nodes_.push_back(below);
    nodes_.push_back(above);
    return leaf_count_++;
}

/// No leaf if the point lies in a plane.
int CutTree::leafOf(const Vec3& x) const {
    int node = 0;
    while (nodes_[node].below >= 0) {
        const double height = nodes_[node].plane.height(x);
        if (std::abs(height) <= tolerance_m_) return no_leaf;
        node = height > 0 ? nodes_[node].above : nodes_[node].below;
    }
    return nodes_[node].leaf;
}

void CutTree::clip(const std::vector<Vec3>& polygon, const Vec3& outward, int node,
                   std::vector<std::vector<Vec3>>& points) const {
    const Node& here = nodes_[node];
    if (here.below < 0) {
        points[here.leaf].insert(points[here.leaf].end(), polygon.begin(), polygon.end());
        return;
    }
    for (const bool above : {false, true})
        if (isOn(above, polygon, outward, here.plane, tolerance_m_))
            clip(partOf(polygon, here.plane, above, tolerance_m_), outward, above ? here.above : here.below,
                 points);
}

std::vector<std::vector<Vec3>> CutTree::pointsOfLeaves(const TriangleMesh& surface) const {
    std::vector<std::vector<Vec3>> points(leaf_count_);
    std::vector<int> leaf_of_vertex;
    for (const Vec3& x : surface.vertices) {
        leaf_of_vertex.push_back(leafOf(x));
        if (leaf_of_vertex.back() != no_leaf) points[leaf_of_vertex.back()].push_back(x);
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const int leaf = leaf_of_vertex[a];
        if (leaf != no_leaf && leaf == leaf_of_vertex[b] && leaf == leaf_of_vertex[c]) continue;
        const TriangleCorners corners = cornersOf(surface, t);
        clip({corners.begin(), corners.end()}, areaVector(corners), 0, points);
    }
    return points;
}

}  // namespace sherd
