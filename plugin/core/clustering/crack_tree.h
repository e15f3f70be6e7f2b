#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// A plane: all x with normal . x = offset_m.
struct CrackPlane {
    Vec3 normal = Vec3::UnitX();  ///< unit
    double offset_m = 0;

    double distance(const Vec3& x) const { return normal.dot(x) - offset_m; }
};

/// How a body was cut, plane after plane: a node is a part of it, and its children are what a plane or gaps
/// split it into.
class CrackTree {
  public:
    /// Adds a part that no plane bounds; returns its number.
    int addRoot();

    /// Splits a part by a plane; returns the number of the child at negative distances. The other's is the
    /// next.
    int cut(int part, const CrackPlane& plane);

    /// Adds a child to a part that is in several pieces, with gaps between them.
    int addPiece(int part);

    /// Says that roots may touch: then no plane tells where they do.
    void letRootsTouch() { roots_touch_ = true; }
    bool rootsTouch() const { return roots_touch_; }

    int size() const { return static_cast<int>(nodes_.size()); }
    int parentOf(int part) const { return nodes_[part].parent; }
    /// What splits a part; nullptr if no plane does.
    const CrackPlane* planeThrough(int part) const {
        return nodes_[part].below < 0 ? nullptr : &nodes_[part].plane;
    }
    /// Of a part that a plane splits: the child at negative distances. The other's is the next.
    int below(int part) const { return nodes_[part].below; }
    /// The pieces that a part is in, or the roots for -1; ascending, none of a part in one piece.
    const std::vector<int>& piecesOf(int part) const { return part < 0 ? roots_ : nodes_[part].pieces; }

    /// Signed distance of x from the plane that separates part a from part b, positive on the side of a, m;
    /// NaN if they lie in different pieces of one part.
    double lead(int a, int b, const Vec3& x) const;

  private:
    struct Node {
        int parent, depth;
        int side;            // of the parent's plane: -1, 1, or 0 if there is none
        int below = -1;      // the first of two children; -1 if no plane cuts the part
        CrackPlane plane{};  // that cuts the part, if one does
        std::vector<int> pieces{};
    };

    int add(int parent, int side);

    std::vector<Node> nodes_;
    std::vector<int> roots_;
    bool roots_touch_ = false;
};

}  // namespace sherd
