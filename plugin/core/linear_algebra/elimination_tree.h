#pragma once

#include <vector>

#include "core/linear_algebra/block_graph.h"

namespace sherd {

/// How the columns of a Cholesky factor depend on each other. Columns are numbered in a postorder of their
/// tree: those below a column come right before it.
struct EliminationTree {
    std::vector<int> order;   ///< per column: the vertex of the graph that is eliminated there
    std::vector<int> parent;  ///< per column: the first row below its diagonal, or -1
    std::vector<int> counts;  ///< per column: blocks in it, that of the diagonal included

    double blocks() const;  ///< in all columns
};

/// Of the order in which vertices are to be eliminated; a postorder of it makes the same fill. Liu 1990;
/// counts by Gilbert, Ng and Peyton 1994.
EliminationTree eliminationTree(const BlockGraph& graph, const std::vector<int>& order);

}  // namespace sherd
