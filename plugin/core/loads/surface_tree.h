#pragma once

#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace sherd {

/// Triangles side by side that lie nearly in one plane, as one.
struct FlatPart {
    Vec3 centre = Vec3::Zero();  ///< m
    Vec3 area = Vec3::Zero();    ///< m^2, outward
};

/// A part of a surface: single triangles, and those that are taken together.
struct SurfaceParts {
    std::vector<int> triangles;  ///< ascending
    std::vector<FlatPart> flat;
};

/// A tree of boxes over a surface's triangles, so that what is near a contact is found without looking at all
/// of them. Finds what a look at all triangles in their order would find, in that order.
class SurfaceTree {
  public:
    /// The surface has to outlive the tree.
    explicit SurfaceTree(const TriangleMesh& surface);
    SurfaceTree(const TriangleMesh&&) = delete;  // it would be gone

    const TriangleMesh& surface() const { return surface_; }

    /// Triangles in boxes that `reaches(box)` does not rule out, ascending. A box that holds another one must
    /// not be ruled out if that one is not.
    template <class Reaches>
    std::vector<int> trianglesWhere(const Reaches& reaches) const {
        std::vector<int> found = unsortedWhere(reaches);
        std::sort(found.begin(), found.end());
        return found;
    }

    /// The same in the tree's own order: where there are thousands, sorting takes longer than finding.
    template <class Reaches>
    std::vector<int> unsortedWhere(const Reaches& reaches) const {
        std::vector<int> found;
        if (!nodes_.empty()) collect(0, reaches, found);
        return found;
    }

    /// The same, but flat parts whose box `isSmall` counts as one: where a mesh is finer than is needed, its
    /// triangles cost nothing.
    template <class Reaches, class IsSmall>
    SurfaceParts partsWhere(const Reaches& reaches, const IsSmall& isSmall) const {
        SurfaceParts found;
        if (!nodes_.empty()) collectParts(0, reaches, isSmall, found);
        std::sort(found.triangles.begin(), found.triangles.end());
        return found;
    }

    /// Those with a box within `radius` of a point, ascending.
    std::vector<int> trianglesNear(const Vec3& point, double radius) const;

    /// The triangle for which `squared_distance(triangle)` from `point` is least, the first of equals; -1 if
    /// it is infinite for all.
    template <class SquaredDistance>
    int nearest(const Vec3& point, const SquaredDistance& squared_distance) const {
        Nearest best;
        if (!nodes_.empty()) descend(0, point, squared_distance, best);
        return best.triangle;
    }

  private:
    struct Node {
        Eigen::AlignedBox3d box;
        int begin, end;  ///< in `triangles_`
        int right = 0;   ///< the node of the second half; that of the first one comes next; 0: a leaf
        bool is_flat = false;
        Eigen::Vector3f centre = Eigen::Vector3f::Zero(), area = centre;  ///< as in FlatPart
    };
    struct Nearest {
        double squared = std::numeric_limits<double>::infinity();
        int triangle = -1;
    };

    struct Item;
    struct Sums;

    int build(int begin, int end, std::vector<Item>& items, Sums& sums);
    static int split(int begin, int end, int axis, double middle, std::vector<Item>& items);

    template <class Reaches>
    void collect(int index, const Reaches& reaches, std::vector<int>& found) const {
        const Node& node = nodes_[index];
        if (!reaches(node.box)) return;
        if (node.right == 0) {
            found.insert(found.end(), triangles_.begin() + node.begin, triangles_.begin() + node.end);
            return;
        }
        collect(index + 1, reaches, found);
        collect(node.right, reaches, found);
    }

    template <class Reaches, class IsSmall>
    void collectParts(int index, const Reaches& reaches, const IsSmall& isSmall, SurfaceParts& found) const {
        const Node& node = nodes_[index];
        if (!reaches(node.box)) return;
        if (node.is_flat && isSmall(node.box)) {
            found.flat.push_back({node.centre.cast<double>(), node.area.cast<double>()});
        } else if (node.right == 0) {
            found.triangles.insert(found.triangles.end(), triangles_.begin() + node.begin,
                                   triangles_.begin() + node.end);
        } else {
            collectParts(index + 1, reaches, isSmall, found);
            collectParts(node.right, reaches, isSmall, found);
        }
    }

    template <class SquaredDistance>
    void descend(int index, const Vec3& point, const SquaredDistance& squared_distance, Nearest& best) const {
        const Node& node = nodes_[index];
        if (node.box.squaredExteriorDistance(point) > best.squared) return;
        if (node.right == 0) {
            for (int i = node.begin; i < node.end; ++i) {
                const double squared = squared_distance(triangles_[i]);
                if (squared > best.squared || (squared == best.squared && triangles_[i] > best.triangle))
                    continue;
                if (squared < std::numeric_limits<double>::infinity()) best = {squared, triangles_[i]};
            }
            return;
        }
        const bool left_first = nodes_[index + 1].box.squaredExteriorDistance(point) <=
                                nodes_[node.right].box.squaredExteriorDistance(point);
        descend(left_first ? index + 1 : node.right, point, squared_distance, best);
        descend(left_first ? node.right : index + 1, point, squared_distance, best);
    }

    const TriangleMesh& surface_;
    std::vector<int> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace sherd
