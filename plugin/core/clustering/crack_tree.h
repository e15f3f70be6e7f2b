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
    int addRoot() { return add(-1, 0); }

    /// Splits a part by a plane; returns the number of the child at negative distances. The other's is the
    /// next.
    int cut(int part, const CrackPlane& plane);

    /// Adds a child to a part that is in several pieces, with gaps between them.
    int addPiece(int part) { return add(part, 0); }

    /// Signed distance of x from the plane that separates part a from part b, positive on the side of a, m;
    /// NaN if they lie in different pieces of one part.
    double lead(int a, int b, const Vec3& x) const;

  private:
    struct Node {
        int parent, depth;
        int side;            // of the parent's plane: -1, 1, or 0 if there is none
        CrackPlane plane{};  // that cuts the part, if one does
    };

    int add(int parent, int side);

    std::vector<Node> nodes_;
};

}  // namespace sherd
