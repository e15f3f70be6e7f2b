#include "geometry/convex/cut_tree.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/plane_crossing.h"

namespace sherd {

namespace {

constexpr int no_leaf = -1;

/// Whether a polygon of the surface is on one side of a plane, at least in part. What lies in the plane is on
/// the side where the solid is.
bool isOn(bool above, const std::vector<CutTree::Corner>& polygon, const Vec3& outward,
          const AxisPlane& plane, double tolerance_m) {
    double lowest = 0, highest = 0;
    for (const CutTree::Corner& corner : polygon) {
        lowest = std::min(lowest, plane.height(corner.x));
        highest = std::max(highest, plane.height(corner.x));
    }
    if (lowest >= -tolerance_m && highest <= tolerance_m) return above == (outward[plane.axis] < 0);
    return above ? highest > tolerance_m : lowest < -tolerance_m;
}

/// The part of a convex polygon on one side of a plane.
void takePart(const std::vector<CutTree::Corner>& polygon, const AxisPlane& plane, bool above,
              double tolerance_m, std::vector<CutTree::Corner>& part) {
    part.clear();
    const auto height = [&](int i) { return plane.height(polygon[i].x); };
    walkAcrossPlane(
        static_cast<int>(polygon.size()), [&](int i) { return height(i) >= 0; },
        [&](int i, bool is_above) {
            if (is_above == above || std::abs(height(i)) <= tolerance_m) part.push_back(polygon[i]);
        },
        [&](int i, int next, bool) {
            part.push_back({planeCrossing(polygon[i].x, height(i), polygon[next].x, height(next)), true});
        });
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

void CutTree::clip(std::size_t depth, const Vec3& outward, int node, Clipping& clipping) const {
    const Node& here = nodes_[node];
    if (here.below < 0) {
        for (const Corner& corner : clipping.polygons[depth])
            if (corner.is_new) clipping.points[here.leaf].push_back(corner.x);
        return;
    }
    if (clipping.polygons.size() == depth + 1) clipping.polygons.emplace_back();
    for (const bool above : {false, true}) {
        const std::vector<Corner>& polygon = clipping.polygons[depth];
        if (!isOn(above, polygon, outward, here.plane, tolerance_m_)) continue;
        takePart(polygon, here.plane, above, tolerance_m_, clipping.polygons[depth + 1]);
        clip(depth + 1, outward, above ? here.above : here.below, clipping);
    }
}

std::vector<std::vector<Vec3>> CutTree::pointsOfLeaves(const TriangleMesh& surface) const {
    Clipping clipping;
    clipping.points.resize(leaf_count_);
    clipping.polygons.resize(1);
    std::vector<int> leaf_of_vertex;
    leaf_of_vertex.reserve(surface.vertices.size());
    for (const Vec3& x : surface.vertices) {
        const int leaf = leafOf(x);
        leaf_of_vertex.push_back(leaf);
        if (leaf != no_leaf) clipping.points[leaf].push_back(x);
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const int leaf = leaf_of_vertex[a];
        if (leaf != no_leaf && leaf == leaf_of_vertex[b] && leaf == leaf_of_vertex[c]) continue;
        clipping.polygons[0].clear();
        for (const int corner : surface.triangles[t])
            clipping.polygons[0].push_back({surface.vertices[corner], leaf_of_vertex[corner] == no_leaf});
        clip(0, areaVector(cornersOf(surface, t)), 0, clipping);
    }
    return std::move(clipping.points);
}

}  // namespace sherd
