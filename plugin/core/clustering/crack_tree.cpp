#include "core/clustering/crack_tree.h"

#include <limits>

namespace sherd {

int CrackTree::add(int parent, int side) {
    nodes_.push_back({parent, parent < 0 ? 0 : nodes_[parent].depth + 1, side});
    return static_cast<int>(nodes_.size()) - 1;
}

int CrackTree::cut(int part, const CrackPlane& plane) {
    nodes_[part].plane = plane;
    const int below = add(part, -1);
    add(part, 1);
    nodes_[part].below = below;
    return below;
}

int CrackTree::addRoot() {
    roots_.push_back(add(-1, 0));
    return roots_.back();
}

int CrackTree::addPiece(int part) {
    const int piece = add(part, 0);
    nodes_[part].pieces.push_back(piece);
    return piece;
}

double CrackTree::lead(int a, int b, const Vec3& x) const {
    while (nodes_[a].parent != nodes_[b].parent) {
        const bool a_is_deeper = nodes_[a].depth >= nodes_[b].depth;
        if (nodes_[a].depth <= nodes_[b].depth) b = nodes_[b].parent;
        if (a_is_deeper) a = nodes_[a].parent;
    }
    const Node &of_a = nodes_[a], &of_b = nodes_[b];
    if (of_a.side == of_b.side) return std::numeric_limits<double>::quiet_NaN();
    return of_a.side * nodes_[of_a.parent].plane.distance(x);
}

}  // namespace sherd
