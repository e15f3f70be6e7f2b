#pragma once

#include <vector>

#include "core/linear_algebra/elimination_tree.h"

namespace sherd {

/// The columns of a Cholesky factor in groups that share their rows (supernodes), each to be eliminated in
/// one dense matrix, its front. Fronts are numbered so that each comes right behind all below it. Small ones
/// are joined with those above them, though that stores zeros: dense blocks have to be large to be fast.
struct FrontTree {
    std::vector<int> order;                  ///< per column: the vertex of the graph that is eliminated there
    std::vector<int> place;                  ///< per vertex: its column
    std::vector<int> first_column;           ///< per front and one more
    std::vector<int> parent;                 ///< per front; -1: it ends a component
    std::vector<std::vector<int>> rows;      ///< per front: below its own columns, ascending
    std::vector<std::vector<int>> children;  ///< per front, ascending

    FrontTree(const BlockGraph& graph, const EliminationTree& tree, int block_size);

    int count() const { return static_cast<int>(parent.size()); }
    int columns(int front) const { return first_column[front + 1] - first_column[front]; }
    int height(int front) const { return columns(front) + static_cast<int>(rows[front].size()); }
};

}  // namespace sherd
