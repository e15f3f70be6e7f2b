#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

namespace sherd {

/// A plane across an axis.
struct AxisPlane {
    int axis = 0;
    double offset = 0;                                               ///< m
    double height(const Vec3& x) const { return x[axis] - offset; }  ///< m, of a point above it
};

/// Space cut by a plane, its parts by further ones: a tree whose leaves are boxes.
class CutTree {
  public:
    /// What is that near to a plane, m, lies in it.
    explicit CutTree(double tolerance_m) : tolerance_m_(tolerance_m) {}
    int leafCount() const { return leaf_count_; }
    /// Cuts a leaf. What lies below stays that leaf; what lies above is a new one, whose number is returned.
    int cut(int leaf, const AxisPlane& plane);

    /// The points of each leaf whose hull is that of the part of the surface there: vertices, and where
    /// triangles cross the planes.
    std::vector<std::vector<Vec3>> pointsOfLeaves(const TriangleMesh& surface) const;

    /// Of what is left of a triangle.
    struct Corner {
        Vec3 x;
        bool is_new = false;  ///< in a plane, so that it is not among the points of a leaf as a vertex
    };

  private:
    struct Node {
        AxisPlane plane;
        int below = -1, above = -1;  // nodes; -1: a leaf
        int leaf = 0;
    };
    int nodeOf(int leaf) const;
    int leafOf(const Vec3& x) const;
    struct Clipping {
        std::vector<std::vector<Vec3>> points;      // of each leaf
        std::vector<std::vector<Corner>> polygons;  // of each depth of the tree
    };
    /// Adds the new corners of what is left in each leaf of the polygon of a depth.
    void clip(std::size_t depth, const Vec3& outward, int node, Clipping& clipping) const;

    double tolerance_m_;
    std::vector<Node> nodes_ = std::vector<Node>(1);
    int leaf_count_ = 1;
};

}  // namespace sherd
